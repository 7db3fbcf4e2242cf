/// Accuracy against time, as CSV and as a plot.
#pragma once

#include "engine/study/sweep.h"

#include <string>

namespace hanei {

/// One row a run and set of points.
std::string sweep_csv(const Sweep& sweep);

/// Log-log plots as SVG: time across, error up, one line a method, each marker with its figures as a tool
/// tip. Side by side mean error, 95th percentile and greatest; a row of three for each set of points.
/// Errors above 1000 % are drawn at the upper edge.
std::string sweep_svg(const Sweep& sweep, const std::string& title);

}  // namespace hanei
