#include "engine/report/validation_report.h"

#include "engine/report/numbers.h"

#include <algorithm>
#include <fmt/format.h>

namespace hanei {
namespace {

constexpr const char* columns = "{:<15} {:<54} {:<13} {:>6} {:>9} {:>9} {:>9}  {}\n";

std::string share(double value) { return fmt::format("{:.1e}", value); }

}  // namespace

std::string_view name_of(Grade grade) {
    switch (grade) {
        case Grade::top:
            return "top";
        case Grade::pass:
            return "pass";
        case Grade::fail:
            return "fail";
        case Grade::unsupported:
            return "unsupported";
    }
    return "";
}

std::size_t Validation::held() const {
    return static_cast<std::size_t>(
        std::count_if(rows.begin(), rows.end(), [](const ValidationRow& row) { return row.holds(); }));
}

std::size_t Validation::points() const {
    std::size_t sum = 0;
    for (const ValidationRow& row : rows) sum += row.points;
    return sum;
}

std::string validation_heading() {
    return fmt::format(fmt::runtime(columns), "case", "proves", "expected by", "points", "worst", "allowed", "mean",
                       "grade");
}

std::string line_of(const ValidationRow& row) {
    std::string text = fmt::format(fmt::runtime(columns), row.name, row.proves, row.source, row.points,
                                   share(row.worst), share(row.allowed), share(row.mean), name_of(row.grade));
    if (!row.fault.empty()) text += fmt::format("    {}\n", row.fault);
    return text;
}

std::string verdict_line(const Validation& validation) {
    const std::size_t held = validation.held(), all = validation.rows.size();
    const std::string who =
        fmt::format("Hanei {}, {}, method {}, {} {}", validation.version, validation.date, validation.methods,
                    validation.threads, validation.threads == 1 ? "thread" : "threads");
    const std::string what = validation.holds() ? fmt::format("all {} cases hold", all)
                                                : fmt::format("{} of {} cases fail", all - held, all);
    return fmt::format("{}: {} ({} points, {:.1f} s)", who, what, validation.points(), validation.seconds);
}

std::string validation_notes(const Validation& validation) {
    const char* const notes =
        "\nErrors are shares of the expected value, of a thousandth of the case's greatest where it is less. "
        "\"worst\" is\n"
        "where most of what is allowed is used. \"top\" and \"pass\" are the two tolerances of a case. \"CIE 171\": "
        "the\n"
        "geometry of that test; its expected values, too, are from closed forms and solvers that share no code with "
        "Hanei.\n\n";
    return notes + verdict_line(validation) + '\n';
}

std::string validation_text(const Validation& validation) {
    std::string text = validation_heading();
    for (const ValidationRow& row : validation.rows) text += line_of(row);
    return text + validation_notes(validation);
}

std::string validation_csv(const Validation& validation) {
    std::string text =
        "case,proves,expected_by,points,worst,allowed,mean,grade,seconds,version,date,methods,threads,fault\n";
    for (const ValidationRow& row : validation.rows)
        text += fmt::format("{},{},{},{},{},{},{},{},{:.3f},{},{},{},{},{}\n", csv_field(row.name),
                            csv_field(row.proves), csv_field(row.source), row.points, row.worst, row.allowed, row.mean,
                            name_of(row.grade), row.seconds, csv_field(validation.version), validation.date,
                            csv_field(validation.methods), validation.threads, csv_field(row.fault));
    return text;
}

}  // namespace hanei
