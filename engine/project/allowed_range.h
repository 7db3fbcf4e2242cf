#pragma once

#include <limits>
#include <string_view>

namespace hanei {

/// What a number in a file may be, and what a message says when it is not.
struct AllowedRange {
    double least = -std::numeric_limits<double>::max();
    double most = std::numeric_limits<double>::max();
    std::string_view text = "";  ///< "0 to 180 degrees"

    bool holds(double value) const { return value >= least && value <= most; }
};

}  // namespace hanei
