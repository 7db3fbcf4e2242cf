#include "engine/report/sweep_report.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace hanei {

namespace {

constexpr double width = 860, height = 560, left = 90, right = 40, top = 70, bottom = 70;

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
        return from + (std::log10(value) - low_decade) / (high_decade - low_decade) * (to - from);
    }
};

std::string decade_text(double value) {
    return value >= 1.0 ? fmt::format("{:.0f}", value) : fmt::format("{:g}", value);
}

std::string grid_lines(const Axis& x, const Axis& y) {
    std::string svg;
    for (double decade = x.low_decade; decade <= x.high_decade; ++decade) {
        const double at = x.at(std::pow(10.0, decade));
        svg += fmt::format("<line x1='{0:.1f}' y1='{1}' x2='{0:.1f}' y2='{2}' stroke='#d8dce2'/>\n", at, top,
                           height - bottom);
        svg += fmt::format("<text x='{:.1f}' y='{}' text-anchor='middle'>{}</text>\n", at, height - bottom + 22,
                           decade_text(std::pow(10.0, decade)));
    }
    for (double decade = y.low_decade; decade <= y.high_decade; ++decade) {
        const double at = y.at(std::pow(10.0, decade));
        svg += fmt::format("<line x1='{1}' y1='{0:.1f}' x2='{2}' y2='{0:.1f}' stroke='#d8dce2'/>\n", at, left,
                           width - right);
        svg += fmt::format("<text x='{}' y='{:.1f}' text-anchor='end'>{}</text>\n", left - 10, at + 4,
                           decade_text(std::pow(10.0, decade)));
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

std::string method_line(const std::vector<SweepPoint>& points, Method method, const char* colour, const Axis& x,
                        const Axis& y) {
    std::string path, marks;
    for (const SweepPoint& point : points) {
        if (point.method != method || !(point.mean_error > 0.0)) continue;
        const double at_x = x.at(point.milliseconds), at_y = y.at(100.0 * point.mean_error);
        path += fmt::format("{}{:.1f},{:.1f} ", path.empty() ? "M" : "L", at_x, at_y);
        marks += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='5' fill='{}'/>\n", at_x, at_y, colour);
        marks += fmt::format("<text x='{:.1f}' y='{:.1f}' font-size='12' fill='{}'>{:g} m</text>\n", at_x + 9, at_y - 8,
                             colour, point.max_patch);
    }
    return fmt::format("<path d='{}' fill='none' stroke='{}' stroke-width='2'/>\n", path, colour) + marks;
}

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) safe += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
    return safe;
}

}  // namespace

std::string sweep_csv(const std::vector<SweepPoint>& points) {
    std::string text = "method,max_patch_m,unknowns,time_ms,mean_error_percent,p95_error_percent,max_error_percent\n";
    for (const SweepPoint& point : points)
        text += fmt::format("{},{},{},{:.2f},{:.5f},{:.5f},{:.5f}\n", name_of(point.method), point.max_patch,
                            point.unknowns, point.milliseconds, 100 * point.mean_error, 100 * point.p95_error,
                            100 * point.max_error);
    return text;
}

std::string sweep_svg(const std::vector<SweepPoint>& points, const std::string& title) {
    double fastest = 1e30, slowest = 0.0, best = 1e30, worst = 0.0;
    for (const SweepPoint& point : points) {
        fastest = std::min(fastest, point.milliseconds);
        slowest = std::max(slowest, point.milliseconds);
        if (!(point.mean_error > 0.0)) continue;
        best = std::min(best, 100.0 * point.mean_error);
        worst = std::max(worst, 100.0 * point.mean_error);
    }
    if (!(worst > 0.0)) best = 0.1, worst = 1.0;
    if (!(slowest > 0.0)) fastest = 1.0, slowest = 10.0;
    const Axis x(fastest, slowest, left, width - right), y(best, worst, height - bottom, top);
    std::string svg = fmt::format(
        "<svg xmlns='http://www.w3.org/2000/svg' width='{0}' height='{1}' viewBox='0 0 {0} {1}' "
        "font-family='Inter, DejaVu Sans, sans-serif' font-size='14' fill='#2b313b'>\n"
        "<rect width='100%' height='100%' fill='white'/>\n",
        width, height);
    svg += fmt::format("<text x='{}' y='32' font-size='18'>{}: accuracy against time</text>\n", left, escaped(title));
    svg += fmt::format(
        "<text x='{}' y='54' font-size='13' fill='#68707c'>mean error at all calculation points, percent of "
        "the mean illuminance, against the finest patch solution</text>\n",
        left);
    svg += grid_lines(x, y);
    svg += fmt::format("<text x='{:.1f}' y='{}' text-anchor='middle'>time, ms (cold start)</text>\n",
                       0.5 * (left + width - right), height - 20);
    svg += fmt::format("<text transform='translate(24 {:.1f}) rotate(-90)' text-anchor='middle'>mean error, %</text>\n",
                       0.5 * (top + height - bottom));
    double line = top + 20;
    for (const Method method : methods) {
        svg += method_line(points, method, colour_of(method), x, y);
        svg += fmt::format("<text x='{}' y='{}' fill='{}' text-anchor='end'>{}</text>\n", width - right - 12, line,
                           colour_of(method), name_of(method));
        line += 20;
    }
    return svg + "</svg>\n";
}

}  // namespace hanei
