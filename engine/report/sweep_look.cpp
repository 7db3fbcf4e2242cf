#include "engine/report/sweep_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace hanei {

std::uint32_t colour_of(Method method) {
    switch (method) {
        case Method::paper:
            return 0xd0563c;
        case Method::paper_closed:
            return 0xc98a1f;
        case Method::patch:
            return 0x3a86c4;
        case Method::linear:
            return 0x2f9a63;
    }
    return 0x808080;
}

std::string css_colour(std::uint32_t colour) { return fmt::format("#{:06x}", colour); }

std::span<const std::pair<double, double>> marker_corners(Method method) {
    using Corner = std::pair<double, double>;
    static constexpr std::array<Corner, 4> square{{{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}}};
    static constexpr std::array<Corner, 4> diamond{{{0.0, -1.25}, {1.25, 0.0}, {0.0, 1.25}, {-1.25, 0.0}}};
    static constexpr std::array<Corner, 3> triangle{{{0.0, -1.25}, {1.15, 0.85}, {-1.15, 0.85}}};
    switch (method) {
        case Method::paper:
            return square;
        case Method::paper_closed:
            return diamond;
        case Method::patch:
            return {};
        case Method::linear:
            return triangle;
    }
    return {};
}

double marker_size(const SweepPoint& point) { return point.complete ? 5.0 : 3.2; }

std::string marks_label(const SweepMarks& marks) {
    std::string label;
    const auto add = [&](std::string_view word) { label += fmt::format("{}{}", label.empty() ? "" : ", ", word); };
    if (marks.current) add("current setting");
    if (marks.paper) add("the paper's own");
    if (marks.preset) add(name_of(*marks.preset));
    return label;
}

double LogAxis::at(double value) const {
    if (!(value > 0.0)) return from;
    const double share = std::log(value / low) / std::log(high / low);
    return from + std::clamp(share, 0.0, 1.0) * (to - from);
}

std::vector<double> LogAxis::marks() const {
    const double decades = std::log10(high / low);
    const double room = std::abs(to - from) / std::max(decades, 0.1);  // pixels a decade
    std::vector<double> values;
    for (double decade = std::floor(std::log10(low)); decade <= std::log10(high); ++decade) {
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double value = digit * std::pow(10.0, decade);
            if (digit > 1.0 && room < 170.0) continue;
            if (value >= 0.999 * low && value <= 1.001 * high) values.push_back(value);
        }
    }
    return values;
}

SweepRange range_of(const Sweep& sweep) {
    constexpr double highest = 1000.0;  // percent
    // Far below what the reference is sure of, differences are no errors.
    const double least = std::max(1e-3, 100.0 * sweep.uncertainty.p95 / 5.0);
    SweepRange range{1e30, 0.0, 1e30, 0.0};
    const auto take = [&](double share) {
        const double percent = 100.0 * share;
        if (!(percent > 0.0)) return;
        range.least = std::min(range.least, std::max(least, percent));
        range.greatest = std::max(range.greatest, std::min(highest, percent));
    };
    for (const SweepPoint& point : sweep.points) {
        if (!(point.milliseconds > 0.0)) continue;
        range.fastest = std::min(range.fastest, point.milliseconds);
        range.slowest = std::max(range.slowest, point.milliseconds);
        for (const SweepErrors& errors : point.errors)
            for (const double share : {errors.mean, errors.p95, errors.max}) take(share);
    }
    if (sweep.lumen.refusal.empty()) take(sweep.lumen.error());
    if (!(range.greatest > 0.0)) range.least = 0.1, range.greatest = 100.0;
    if (!(range.slowest > 0.0)) range.fastest = 1.0, range.slowest = 1000.0;
    // Room for markers at the ends, and at least a decade each way.
    range.fastest /= 1.6;
    range.slowest = std::max(1.6 * range.slowest, 10.0 * range.fastest);
    range.least /= 1.4;
    range.greatest = std::max(1.4 * range.greatest, 10.0 * range.least);
    return range;
}

std::vector<const SweepPoint*> by_width(const Sweep& sweep, Method method) {
    std::vector<const SweepPoint*> points;
    for (const SweepPoint& point : sweep.points)
        if (point.settings.method == method && point.complete && point.shadows && !point.marks.preset)
            points.push_back(&point);
    std::sort(points.begin(), points.end(),
              [](const SweepPoint* a, const SweepPoint* b) { return a->settings.max_patch > b->settings.max_patch; });
    return points;
}

std::vector<const SweepPoint*> frontier_of(const Sweep& sweep) {
    std::vector<const SweepPoint*> points;
    for (const SweepPoint& point : sweep.points)
        if (point.on_frontier) points.push_back(&point);
    std::sort(points.begin(), points.end(),
              [](const SweepPoint* a, const SweepPoint* b) { return a->milliseconds < b->milliseconds; });
    return points;
}

}  // namespace hanei
