/// The gallery of hard cases: small projects beside a table of what is right, read and judged.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/solution/solution.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hanei {

/// What is expected at one calculation point, named as in the project.
struct HardFigure {
    std::string point;
    bool direct_only = false;
    double expected = 0.0, tolerance = 0.0;  ///< lx
    std::optional<double> naive = std::nullopt;
};

/// One row of assets/rooms/hard/cases.json.
struct HardCase {
    std::string file, title;
    std::vector<std::string> covers;  ///< kinds of hard things, as "thin wall"; "P-B6": the reference case it repeats
    std::string why;                  ///< it is hard
    std::string right;                ///< the right answer, and where it follows from
    std::string naive;                ///< what an obvious method does
    std::string naive_by;             ///< how its figures are computed: "paper", "centre"; empty: those of the table
    std::vector<HardFigure> figures;
    std::vector<std::string> finds;  ///< words that the findings of the project must hold
    std::string refusal;             ///< words of the reason why interreflection has no answer; empty: it has one
    std::string same_as;             ///< another file whose figures these must be, within both error bars
    std::optional<double> escaped_lm = std::nullopt;
    double escaped_tolerance = 0.0;
};

/// Where the gallery lies beside the rooms that come with the program.
std::filesystem::path hard_folder();

/// All rows of the folder's table. A fault of the table is noted and its row left out.
std::vector<HardCase> read_hard_cases(const std::filesystem::path& folder, Diagnostics& findings);

/// What came out.
struct HardOutcome {
    struct Figure {
        HardFigure wanted;
        double got = 0.0, error_bar = 0.0;  ///< lx
        std::optional<double> naive = std::nullopt;
    };
    std::vector<Figure> figures;
    std::vector<std::string> findings;  ///< of the file and of the scene
    std::string refusal;
    std::vector<std::string> faults;  ///< how it departs from what is expected; empty: it is right
};

/// Computes a case with the settings of its file, and by the naive method, and judges it.
HardOutcome solve_hard_case(const std::filesystem::path& folder, const HardCase& wanted);

/// The case as a paragraph: why, what is right, what is naive, what came out.
std::string text_of(const HardCase& wanted, const HardOutcome& outcome);

/// One line a case: verdict, file, how far off at most, its error bar, how far off the naive method, what it covers.
std::string row_of(const HardCase& wanted, const HardOutcome& outcome);

/// `hanei check --hard`: all of them, on standard output. exit_answer_is_no when one is wrong.
int check_hard_command();

}  // namespace hanei
