/// Accuracy against time, as CSV, as a table to read and as a plot.
#pragma once

#include "engine/study/sweep.h"

#include <string>

namespace hanei {

/// One row a run and set of points (kind "run"), then what errors are errors of with its own uncertainty
/// ("reference"), the lumen method ("lumen": its mean against the solved mean of the working plane) and what
/// was left out ("left out").
std::string sweep_csv(const Sweep& sweep);

/// What was compared, predicted against found for the presets, the frontier, what was left out.
std::string sweep_text(const Sweep& sweep);

/// Log-log plots as SVG, for light and dark pages: time across, error up; large the 95th percentile of all
/// points, small the mean and the greatest error and, a row each, further sets of points. Methods differ
/// by colour and shape, runs of a few interreflections are small and faint, those without shadows
/// between surfaces hollow; the frontier is a line, the present settings have a ring. Every marker has
/// its figures as a tool tip. Errors above 1000 % are drawn at the upper edge.
std::string sweep_svg(const Sweep& sweep, const std::string& title);

/// "patch, 0.58 m, 4 bounces, no shadows between surfaces": what a run is, in words.
std::string words_of(const SweepPoint& point);

/// "40 ms", "1.3 s": a time with the digits that matter.
std::string time_text(double milliseconds);

/// What a prediction rests on: "studies of this room on this machine".
std::string basis_of(const Prediction& prediction);

/// "0.35 %", of a share.
std::string percent_text(double share);

}  // namespace hanei
