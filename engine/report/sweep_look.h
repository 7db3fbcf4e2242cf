/// How a sweep is drawn, on paper and in the window: colours and shapes of methods, logarithmic axes.
#pragma once

#include "engine/study/sweep.h"

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace hanei {

/// 0xRRGGBB, told apart on light and on dark ground.
std::uint32_t colour_of(Method method);
std::string css_colour(std::uint32_t colour);  ///< "#2c6e9e"

/// Corners of a method's marker within a circle of radius 1, down positive; none: the circle itself.
std::span<const std::pair<double, double>> marker_corners(Method method);

/// Radius at scale 1: complete runs are larger.
double marker_size(const SweepPoint& point);

/// "current setting", "design", "the paper's own"; empty when it stands for nothing else.
std::string marks_label(const SweepMarks& marks);

/// A logarithmic axis onto pixels.
struct LogAxis {
    double low = 1.0, high = 10.0;  ///< above 0
    double from = 0.0, to = 1.0;    ///< pixels of low and high
    double at(double value) const;  ///< kept within the axis
    /// Figures to be written at it: decades, and 2 and 5 of them where there are few.
    std::vector<double> marks() const;
};

/// Ends of both axes over all sets and figures; ms and percent.
struct SweepRange {
    double fastest = 1.0, slowest = 1000.0, least = 0.1, greatest = 100.0;
};
SweepRange range_of(const Sweep& sweep);

/// Complete runs with shadows, from wide to narrow patches; presets are left out.
std::vector<const SweepPoint*> by_width(const Sweep& sweep, Method method);

/// From the soonest to the most exact.
std::vector<const SweepPoint*> frontier_of(const Sweep& sweep);

}  // namespace hanei
