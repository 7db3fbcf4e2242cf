/// The signed-off table of the built-in reference cases.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace hanei {

/// How a computed value, and the worst of many, stands against what is expected.
enum class Grade { top, pass, fail, unsupported };
std::string_view name_of(Grade grade);

/// One case. Errors are shares of the expected value; where that is less than a thousandth of the greatest one
/// of the case, of this thousandth.
struct ValidationRow {
    std::string name;    ///< "P-E1"
    std::string proves;  ///< "Penumbra of a box"
    std::string source;  ///< of what is expected: "closed form"
    std::size_t points = 0;
    double worst = 0.0;    ///< error of the point that uses most of what is allowed
    double allowed = 0.0;  ///< at that point
    double mean = 0.0;     ///< error over all points
    double seconds = 0.0;
    Grade grade = Grade::unsupported;
    std::string fault{};  ///< what is wrong in a case that fails: one sentence
    bool holds() const { return grade == Grade::top || grade == Grade::pass; }
};

/// The table and who signs it.
struct Validation {
    std::string version;  ///< of the program
    std::string date;     ///< "2026-11-22"
    std::string methods;  ///< of interreflection: "linear"
    int threads = 1;
    double seconds = 0.0;
    std::vector<ValidationRow> rows;
    std::size_t held() const;  ///< cases that hold
    std::size_t points() const;
    bool holds() const { return !rows.empty() && held() == rows.size(); }
};

/// One line of it and the heading above, for a terminal.
std::string validation_heading();
std::string line_of(const ValidationRow& row);

/// "Hanei 0.1.0, 2026-11-22, method linear, 2 threads: all 47 cases hold (549 points, 9.8 s)"
std::string verdict_line(const Validation& validation);

/// What stands below the lines: where the expected values are from, and the verdict.
std::string validation_notes(const Validation& validation);

/// Heading, lines, where the expected values are from, verdict.
std::string validation_text(const Validation& validation);

/// A row a case, the verdict's parts in columns of their own: what was shown can be shown again.
std::string validation_csv(const Validation& validation);

}  // namespace hanei
