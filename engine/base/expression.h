/// Figures as people type them: "1/3", "2*0.6 + 0.05", "(1.2 m + 30 cm)/2", "5'-3 1/2\"".
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace hanei {

/// A unit that may stand behind a figure, and what it is worth in the unit of the result.
struct UnitWord {
    std::string_view word;
    double worth;
};

struct Calculated {
    std::optional<double> value;  ///< finite; empty: see the fault
    std::string fault;            ///< one sentence, what is wrong and what would be right
};

/// Adds, subtracts, multiplies and divides, with brackets and signs; "3 1/2" is three and a half. A
/// figure without a unit counts `bare`: once in the result, and in sums beside figures with a unit.
/// Feet and inches may stand together: 5'3", 5' 3 1/2", 5'-3 1/2".
///
/// Needs     nothing: any text has a value or a fault.
/// Cost      linear; texts beyond 200 letters are refused.
Calculated calculated(std::string_view text, std::span<const UnitWord> units, double bare);

}  // namespace hanei
