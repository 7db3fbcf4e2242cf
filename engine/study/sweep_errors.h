/// How far values at points are from others.
#pragma once

#include "engine/solution/solution.h"

#include <string>
#include <vector>

namespace hanei {

/// Errors at the points of one set, as shares of the expected value and in lux. Where the value is less
/// than a tenth of the set's mean, shares are of this tenth, so that dark places do not count for more
/// than they light.
struct SweepErrors {
    std::string set{};  ///< name of a grid, "points", a reference case's set; "all": every point
    double mean = 0.0;
    double p95 = 0.0;
    double max = 0.0;
    double mean_lux = 0.0;
    double p95_lux = 0.0;
    double max_lux = 0.0;
};

/// A value that is compared, and the set it counts for. `lux` is below 0 inside solids.
struct ComparedValue {
    double lux = 0.0;
    std::string set;
};

/// Of all points and grids, in order; points count for `point_sets` where there are any, else for "points".
std::vector<ComparedValue> compared_values(const Solution& solution, const std::vector<std::string>& point_sets);

/// Of "all" first, then of each set when there are several. Points that are expected inside solids are
/// left out; values that are no number are as wrong as can be.
/// Needs     as many values of both.
std::vector<SweepErrors> errors_by_set(const std::vector<ComparedValue>& got,
                                       const std::vector<ComparedValue>& expected);

}  // namespace hanei
