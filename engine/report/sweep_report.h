/// Accuracy against time, as CSV and as a plot.
#pragma once

#include "engine/study/study.h"

#include <string>
#include <vector>

namespace hanei {

std::string sweep_csv(const std::vector<SweepPoint>& points);

/// A log-log plot as SVG: time across, mean error up, one line a method, every point labelled with
/// its patch width.
std::string sweep_svg(const std::vector<SweepPoint>& points, const std::string& title);

}  // namespace hanei
