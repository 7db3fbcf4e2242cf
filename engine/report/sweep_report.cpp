#include "engine/report/sweep_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace hanei {

namespace {

// Pixels. Three panels a row; the legend above them, the time axis below each.
constexpr double panel_width = 290, panel_height = 210, left = 96, between = 30, top = 138, row_height = 280;
constexpr double right = 30, bottom = 14;
constexpr double total_width = left + 3 * panel_width + 2 * between + right;
constexpr const char* quiet = "#68707c";
constexpr double highest = 1000.0;  // percent: what is more is drawn there

struct Figure {
    const char* name;
    double SweepErrors::*of;
};
constexpr std::array figures{Figure{"mean error", &SweepErrors::mean}, Figure{"95th percentile", &SweepErrors::p95},
                             Figure{"greatest error", &SweepErrors::max}};

/// A logarithmic axis of whole decades onto pixels.
struct Axis {
    double low_decade = 0.0, high_decade = 1.0, from = 0.0, to = 1.0;

    Axis(double low, double high, double from_pixel, double to_pixel)
        : low_decade(std::floor(std::log10(low))),
          high_decade(std::ceil(std::log10(high))),
          from(from_pixel),
          to(to_pixel) {
        if (high_decade <= low_decade) high_decade = low_decade + 1.0;
    }
    double at(double value) const {
        const double share = (std::log10(value) - low_decade) / (high_decade - low_decade);
        return from + std::clamp(share, 0.0, 1.0) * (to - from);
    }
};

/// Ends of both axes over all panels.
struct Range {
    double fastest = 1e30, slowest = 0.0, least = 1e30, greatest = 0.0;
};

Range range_of(const Sweep& sweep) {
    Range range;
    for (const SweepPoint& point : sweep.points) {
        range.fastest = std::min(range.fastest, point.milliseconds);
        range.slowest = std::max(range.slowest, point.milliseconds);
        for (const SweepErrors& errors : point.errors) {
            for (const Figure& figure : figures) {
                const double percent = 100.0 * errors.*figure.of;
                if (!(percent > 0.0)) continue;
                range.least = std::min(range.least, percent);
                range.greatest = std::max(range.greatest, std::min(highest, percent));
            }
        }
    }
    if (!(range.greatest > 0.0)) range.least = 0.1, range.greatest = 1.0;
    if (!(range.slowest > 0.0)) range.fastest = 1.0, range.slowest = 10.0;
    return range;
}

std::string decade_text(double value, const char* unit) {
    return (value >= 1.0 ? fmt::format("{:.0f}", value) : fmt::format("{:g}", value)) + unit;
}

std::string grid_lines(const Axis& x, const Axis& y, bool with_errors) {
    std::string svg;
    for (double decade = x.low_decade; decade <= x.high_decade; ++decade) {
        const double at = x.at(std::pow(10.0, decade));
        svg += fmt::format("<line x1='{0:.1f}' y1='{1:.1f}' x2='{0:.1f}' y2='{2:.1f}' stroke='#d8dce2'/>\n", at, y.to,
                           y.from);
        const std::string text =
            decade < 3.0 ? decade_text(std::pow(10.0, decade), " ms") : decade_text(std::pow(10.0, decade - 3.0), " s");
        const char* anchor = decade == x.low_decade ? "start" : decade == x.high_decade ? "end" : "middle";
        svg += fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='{}'>{}</text>\n", at, y.from + 20, anchor, text);
    }
    for (double decade = y.low_decade; decade <= y.high_decade; ++decade) {
        const double at = y.at(std::pow(10.0, decade));
        svg += fmt::format("<line x1='{1:.1f}' y1='{0:.1f}' x2='{2:.1f}' y2='{0:.1f}' stroke='#d8dce2'/>\n", at, x.from,
                           x.to);
        const double percent = std::pow(10.0, decade);
        if (with_errors)
            svg += fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='end'>{}</text>\n", x.from - 8, at + 4,
                               (percent < highest ? "" : "≥ ") + decade_text(percent, " %"));
    }
    return svg;
}

const char* colour_of(Method method) {
    switch (method) {
        case Method::paper:
            return "#b5523b";
        case Method::paper_closed:
            return "#c98a2b";
        case Method::patch:
            return "#2c6e9e";
        case Method::linear:
            return "#2f8a5b";
    }
    return "#2b313b";
}

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) safe += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
    return safe;
}

std::string method_line(const Sweep& sweep, std::size_t set, const Figure& figure, Method method, const Axis& x,
                        const Axis& y) {
    std::string path, marks;
    for (const SweepPoint& point : sweep.points) {
        if (point.method != method || set >= point.errors.size()) continue;
        const double percent = 100.0 * point.errors[set].*figure.of;
        if (!(percent > 0.0)) continue;
        const double at_x = x.at(point.milliseconds), at_y = y.at(percent);
        path += fmt::format("{}{:.1f},{:.1f} ", path.empty() ? "M" : "L", at_x, at_y);
        marks += fmt::format(
            "<circle cx='{:.1f}' cy='{:.1f}' r='4' fill='{}'><title>{}, patches of {:.3g} m, {} unknowns: {:.3g} % in "
            "{:.3g} ms</title></circle>\n",
            at_x, at_y, colour_of(method), name_of(method), point.max_patch, point.unknowns, percent,
            point.milliseconds);
    }
    return fmt::format("<path d='{}' fill='none' stroke='{}' stroke-width='2'/>\n", path, colour_of(method)) + marks;
}

/// Each method with the widths of its markers.
std::string legend(const Sweep& sweep) {
    std::string svg;
    double at = left;
    for (const Method method : methods) {
        std::string widths;
        for (const SweepPoint& point : sweep.points)
            if (point.method == method)
                widths += (widths.empty() ? "" : " · ") + fmt::format("{:.2g}", point.max_patch);
        svg += fmt::format("<circle cx='{:.1f}' cy='82' r='5' fill='{}'/>", at + 5, colour_of(method));
        svg += fmt::format("<text x='{:.1f}' y='87' fill='{}' font-weight='600'>{}</text>\n", at + 17,
                           colour_of(method), name_of(method));
        svg += fmt::format("<text x='{:.1f}' y='104' fill='{}' font-size='12'>{} m</text>\n", at + 17, quiet, widths);
        at += 0.25 * (total_width - left - right);
    }
    return svg;
}

}  // namespace

std::string sweep_csv(const Sweep& sweep) {
    std::string text =
        "method,max_patch_m,unknowns,time_ms,set,mean_error_percent,p95_error_percent,max_error_percent\n";
    for (const SweepPoint& point : sweep.points) {
        for (const SweepErrors& errors : point.errors) {
            std::string set = errors.set;
            std::replace_if(
                set.begin(), set.end(), [](char c) { return c == ',' || c == '"' || c == '\n'; }, ' ');
            text += fmt::format("{},{:.6g},{},{:.2f},{},{:.6g},{:.6g},{:.6g}\n", name_of(point.method), point.max_patch,
                                point.unknowns, point.milliseconds, set, 100 * errors.mean, 100 * errors.p95,
                                100 * errors.max);
        }
    }
    return text;
}

std::string sweep_svg(const Sweep& sweep, const std::string& title) {
    std::vector<std::string> sets;
    if (!sweep.points.empty())
        for (const SweepErrors& errors : sweep.points.front().errors) sets.push_back(errors.set);
    const double height = top + row_height * static_cast<double>(std::max<std::size_t>(1, sets.size())) + bottom;
    std::string svg = fmt::format(
        "<svg xmlns='http://www.w3.org/2000/svg' width='{0}' height='{1}' viewBox='0 0 {0} {1}' "
        "font-family='Inter, DejaVu Sans, sans-serif' font-size='13' fill='#2b313b'>\n"
        "<rect width='100%' height='100%' fill='white'/>\n",
        total_width, height);
    svg += fmt::format("<text x='{}' y='32' font-size='18'>{}: accuracy against time</text>\n", left, escaped(title));
    svg += fmt::format(
        "<text x='{}' y='54' fill='{}'>errors in percent of the value, against {}; time from a cold start to every "
        "value</text>\n",
        left, quiet, escaped(sweep.against));
    svg += legend(sweep);
    const Range range = range_of(sweep);
    for (std::size_t set = 0; set < sets.size(); ++set) {
        const double upper = top + row_height * static_cast<double>(set) + 20;
        for (std::size_t column = 0; column < figures.size(); ++column) {
            const double from = left + (panel_width + between) * static_cast<double>(column);
            const Axis x(range.fastest, range.slowest, from, from + panel_width);
            const Axis y(range.least, range.greatest, upper + panel_height, upper);
            svg += fmt::format("<text x='{:.1f}' y='{:.1f}' font-weight='600'>{}: {}</text>\n", from, upper - 9,
                               escaped(sets[set] == "all" ? "all points" : sets[set]), figures[column].name);
            svg += grid_lines(x, y, column == 0);
            for (const Method method : methods) svg += method_line(sweep, set, figures[column], method, x, y);
        }
    }
    return svg + "</svg>\n";
}

}  // namespace hanei
