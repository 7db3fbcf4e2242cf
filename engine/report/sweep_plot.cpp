#include "engine/report/label_places.h"
#include "engine/report/sweep_look.h"
#include "engine/report/sweep_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace hanei {
namespace {

// Pixels. The large panel with its legend beside it, then rows of small ones.
constexpr double left = 76, right = 24, total_width = 1000, legend_width = 196;
constexpr double large_width = total_width - left - right - legend_width, large_height = 400, large_top = 96;
constexpr double small_top = large_top + large_height + 84, small_height = 190, row_height = 290, between = 80;

struct Figure {
    const char* name;
    double SweepErrors::*of;
};
constexpr std::array figures{Figure{"Mean error", &SweepErrors::mean}, Figure{"95 of 100 points", &SweepErrors::p95},
                             Figure{"Greatest error", &SweepErrors::max}};

struct Panel {
    LogAxis x, y;
    std::size_t set = 0;
    const Figure* figure = nullptr;
    bool large = false;
};

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text)
        safe += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '>' ? "&gt;" : c == '\'' ? "&#39;" : std::string(1, c);
    return safe;
}

std::string text_at(double x, double y, const char* more, const std::string& text) {
    return fmt::format("<text x='{:.1f}' y='{:.1f}' {}>{}</text>\n", x, y, more, escaped(text));
}

std::string grid_lines(const Panel& panel) {
    const LogAxis &x = panel.x, &y = panel.y;
    std::string svg;
    for (const double value : x.marks()) {
        const double at = x.at(value);
        svg += fmt::format("<line class='g' x1='{0:.1f}' y1='{1:.1f}' x2='{0:.1f}' y2='{2:.1f}' stroke='#d8dce2'/>\n",
                           at, y.to, y.from);
        svg += text_at(at, y.from + 18, "text-anchor='middle' class='q' fill='#68707c'",
                       value < 1000.0 ? fmt::format("{:g} ms", value) : fmt::format("{:g} s", 1e-3 * value));
    }
    for (const double percent : y.marks()) {
        const double at = y.at(percent);
        svg += fmt::format("<line class='g' x1='{1:.1f}' y1='{0:.1f}' x2='{2:.1f}' y2='{0:.1f}' stroke='#d8dce2'/>\n",
                           at, x.from, x.to);
        svg +=
            text_at(x.from - 8, at + 4, "text-anchor='end' class='q' fill='#68707c'", fmt::format("{:g} %", percent));
    }
    return svg;
}

/// What lies below cannot be told from the reference.
std::string uncertain_band(const Sweep& sweep, const Panel& panel) {
    const double percent = 100.0 * sweep.uncertainty.*panel.figure->of;
    if (panel.set != 0 || !(percent > 0.0)) return {};
    const double at = panel.y.at(percent);
    std::string svg =
        fmt::format("<rect x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{:.1f}' fill='#8a93a0' fill-opacity='0.16'/>\n",
                    panel.x.from, at, panel.x.to - panel.x.from, panel.y.from - at);
    if (panel.large && panel.y.from - at > 16.0)
        svg += text_at(panel.x.from + 8, panel.y.from - 7, "font-size='12' class='q' fill='#68707c'",
                       "within the reference's own uncertainty, " + percent_text(0.01 * percent));
    return svg;
}

std::string shape(Method method, double x, double y, double size, const std::string& look) {
    std::string corners;
    for (const auto& [dx, dy] : marker_corners(method))
        corners += fmt::format("{:.1f},{:.1f} ", x + size * dx, y + size * dy);
    if (corners.empty()) return fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='{:.1f}' {}>", x, y, size, look);
    return fmt::format("<polygon points='{}' {}>", corners, look);
}

const char* end_of_shape(Method method) { return marker_corners(method).empty() ? "</circle>\n" : "</polygon>\n"; }

std::string look_of(const SweepPoint& point) {
    const std::string colour = css_colour(colour_of(point.settings.method));
    if (!point.shadows)
        return fmt::format("fill='none' stroke='{}' stroke-width='1.2' stroke-opacity='{}'", colour,
                           point.complete ? 0.9 : 0.4);
    return fmt::format("fill='{}' fill-opacity='{}'", colour, point.complete ? 1.0 : 0.38);
}

std::string marker(const SweepPoint& point, const Panel& panel) {
    const double percent = 100.0 * point.errors[panel.set].*panel.figure->of;
    const double size = marker_size(point) * (panel.large ? 1.0 : 0.75);
    const Method method = point.settings.method;
    return shape(method, panel.x.at(point.milliseconds), panel.y.at(percent), size, look_of(point)) +
           fmt::format("<title>{}: {} in {}, {} unknowns</title>", words_of(point), percent_text(0.01 * percent),
                       time_text(point.milliseconds), point.unknowns) +
           end_of_shape(method);
}

/// Through the complete runs with shadows of one method, by their widths.
std::string method_line(const Sweep& sweep, const Panel& panel, Method method) {
    std::string path;
    for (const SweepPoint* point : by_width(sweep, method))
        path += fmt::format("{}{:.1f},{:.1f} ", path.empty() ? "M" : "L", panel.x.at(point->milliseconds),
                            panel.y.at(100.0 * point->errors[panel.set].*panel.figure->of));
    if (path.empty()) return {};
    return fmt::format("<path d='{}' fill='none' stroke='{}' stroke-width='1.6' stroke-opacity='0.55'/>\n", path,
                       css_colour(colour_of(method)));
}

/// A stair: nothing measured takes less time and is nearer. Its last step goes on to the border.
std::vector<std::array<double, 2>> frontier_corners(const Sweep& sweep, const Panel& panel) {
    std::vector<std::array<double, 2>> corners;
    for (const SweepPoint* point : frontier_of(sweep)) {
        const double x = panel.x.at(point->milliseconds),
                     y = panel.y.at(100.0 * std::max(point->errors.front().p95, sweep.uncertainty.p95));
        if (!corners.empty()) corners.push_back({x, corners.back()[1]});
        corners.push_back({x, y});
    }
    if (!corners.empty()) corners.push_back({panel.x.to, corners.back()[1]});
    return corners;
}

std::string frontier_line(const Sweep& sweep, const Panel& panel) {
    std::string path;
    for (const auto& [x, y] : frontier_corners(sweep, panel))
        path += fmt::format("{}{:.1f},{:.1f} ", path.empty() ? "M" : "L", x, y);
    if (path.empty()) return {};
    return fmt::format(
        "<path class='f' d='{}' fill='none' stroke='#2b313b' stroke-width='2.4' stroke-linejoin='round'/>\n", path);
}

/// A point that stands for something, or several so near each other that one label names them.
struct Marked {
    double x, y;
    std::string text;
};

std::vector<Marked> marked_points(const Sweep& sweep, const Panel& panel) {
    constexpr double together = 18.0;
    std::vector<Marked> marked;
    for (const SweepPoint& point : sweep.points) {
        const std::string text = marks_label(point.marks);
        if (text.empty()) continue;
        const double x = panel.x.at(point.milliseconds), y = panel.y.at(100.0 * point.errors.front().p95);
        const auto near =
            std::ranges::find_if(marked, [&](const Marked& m) { return std::hypot(m.x - x, m.y - y) < together; });
        if (near == marked.end())
            marked.push_back({x, y, text});
        else
            near->text += ", " + text;
    }
    return marked;
}

/// Names of the points that stand for something, beside them.
std::string labels(const Sweep& sweep, const Panel& panel) {
    LabelPlaces places({panel.x.from, panel.y.to, panel.x.to, panel.y.from});
    std::string svg;
    for (const SweepPoint& point : sweep.points) {
        const double x = panel.x.at(point.milliseconds), y = panel.y.at(100.0 * point.errors.front().p95);
        places.avoid(x, y, point.marks.any() ? 11.0 : 5.0);
        if (point.marks.any())
            svg += fmt::format(
                "<circle class='r' cx='{:.1f}' cy='{:.1f}' r='{}' fill='none' stroke='#2b313b' stroke-width='{}'/>\n",
                x, y, point.marks.current ? 10.5 : 8.5, point.marks.current ? 2.2 : 1.1);
    }
    const auto corners = frontier_corners(sweep, panel);
    for (std::size_t k = 1; k < corners.size(); ++k)
        places.avoid_line(corners[k - 1][0], corners[k - 1][1], corners[k][0], corners[k][1]);
    const auto label = [&](const Marked& marked) {
        constexpr double letter = 8.2, height = 15.0;  // of the widest letters that browsers fall back to
        const LabelPlace at =
            places.place(marked.x, marked.y, letter * static_cast<double>(marked.text.size()), height);
        if (at.is_far)
            svg += fmt::format("<line class='l' x1='{:.1f}' y1='{:.1f}' x2='{:.1f}' y2='{:.1f}' stroke='#68707c'/>\n",
                               marked.x, marked.y, at.anchor_x, at.anchor_y);
        svg += text_at(at.left, at.top + 12, "font-weight='600' class='t' fill='#2b313b'", marked.text);
    };
    std::vector<Marked> all = marked_points(sweep, panel);
    if (sweep.lumen.refusal.empty()) {
        const double x = panel.x.from, y = panel.y.at(100.0 * sweep.lumen.error());
        svg += fmt::format("<path class='f' d='M{0:.1f},{1:.1f} l12,-6 l0,12 z' fill='#8a4fa3'/>\n", x, y);
        places.avoid(x + 6.0, y, 7.0);
        all.push_back({x + 8.0, y, "lumen method, its mean"});
    }
    for (const Marked& marked : all) label(marked);
    return svg;
}

std::string legend(double x, double y) {
    std::string svg;
    const auto row = [&](const std::string& mark, const std::string& text) {
        svg += mark + text_at(x + 22, y + 4, "class='t' fill='#2b313b'", text);
        y += 23;
    };
    for (const Method method : methods) {
        const std::string look = fmt::format("fill='{}'", css_colour(colour_of(method)));
        row(shape(method, x + 8, y, 6, look) + end_of_shape(method), std::string(name_of(method)));
    }
    y += 8;
    const std::string grey = "#68707c";
    row(shape(Method::patch, x + 8, y, 3.6, fmt::format("fill='{}' fill-opacity='0.5'", grey)) + "</circle>\n",
        "1, 2, 4, 10 bounces");
    row(shape(Method::patch, x + 8, y, 5, fmt::format("fill='none' stroke='{}' stroke-width='1.2'", grey)) +
            "</circle>\n",
        "no shadows between");
    svg += text_at(x + 22, y - 3, "class='t' fill='#2b313b'", "surfaces");
    y += 18;
    row(fmt::format("<path class='f' d='M{0:.1f},{1:.1f} h16' stroke='#2b313b' stroke-width='2.4'/>\n", x, y),
        "frontier");
    row(fmt::format(
            "<circle class='r' cx='{:.1f}' cy='{:.1f}' r='7.5' fill='none' stroke='#2b313b' stroke-width='2.2'/>\n",
            x + 8, y),
        "current setting");
    return svg;
}

std::string panel_svg(const Sweep& sweep, const Panel& panel, const std::string& title) {
    std::string svg = text_at(panel.x.from, panel.y.to - 12, "font-weight='600' class='t' fill='#2b313b'", title);
    svg += grid_lines(panel) + uncertain_band(sweep, panel);
    for (const Method method : methods) svg += method_line(sweep, panel, method);
    for (const bool complete : {false, true})
        for (const SweepPoint& point : sweep.points)
            if (point.complete == complete && (panel.large || complete) && panel.set < point.errors.size())
                svg += marker(point, panel);
    if (panel.large) svg += frontier_line(sweep, panel) + labels(sweep, panel);
    return svg;
}

/// The figures of one set side by side; of all points but the one that the large panel shows.
std::string small_row(const Sweep& sweep, const SweepRange& range, std::size_t set, const std::string& name) {
    const double upper = small_top + row_height * static_cast<double>(set);
    const double columns = set == 0 ? 2.0 : 3.0;
    const double width = (total_width - left - right - (columns - 1.0) * between) / columns;
    double from = left;
    std::string svg;
    for (const Figure& figure : figures) {
        if (set == 0 && &figure == &figures[1]) continue;
        const Panel panel{{range.fastest, range.slowest, from, from + width},
                          {range.least, range.greatest, upper + small_height, upper},
                          set,
                          &figure,
                          false};
        svg += panel_svg(sweep, panel, std::string(figure.name) + (set == 0 ? ", all points" : ""));
        if (set > 0 && from == left)
            svg += text_at(left, upper - 36, "class='t' fill='#2b313b' font-weight='600' font-size='15'", name);
        from += width + between;
    }
    return svg;
}

}  // namespace

std::string sweep_svg(const Sweep& sweep, const std::string& title) {
    std::vector<std::string> sets;
    if (!sweep.points.empty())
        for (const SweepErrors& errors : sweep.points.front().errors) sets.push_back(errors.set);
    const double rows = static_cast<double>(std::max<std::size_t>(1, sets.size()));
    const double height = small_top + row_height * rows - 20;
    std::string svg = fmt::format(
        "<svg xmlns='http://www.w3.org/2000/svg' width='{0}' height='{1}' viewBox='0 0 {0} {1}' "
        "font-family='Inter, DejaVu Sans, sans-serif' font-size='13'>\n"
        "<style>@media (prefers-color-scheme: dark) {{ .t {{ fill: #e6e9ee }} .q {{ fill: #9aa4b2 }} .g {{ stroke: "
        "#39414d }} "
        ".f, .r {{ stroke: #e6e9ee }} .l {{ stroke: #9aa4b2 }} }}</style>\n",
        total_width, height);
    svg += text_at(left, 30, "font-size='19' class='t' fill='#2b313b'", title + ": accuracy against time");
    if (sweep.points.empty())
        return svg + text_at(left, 60, "class='q' fill='#68707c'", "No run was finished.") + "</svg>\n";
    svg += text_at(left, 52, "class='q' fill='#68707c' font-size='12'",
                   "Errors against " + sweep.against + "; time from a cold start to every value.");
    const SweepRange range = range_of(sweep);
    Panel large{{range.fastest, range.slowest, left, left + large_width},
                {range.least, range.greatest, large_top + large_height, large_top},
                0,
                &figures[1],
                true};
    svg += panel_svg(sweep, large, "Error that 95 of 100 points are within, all points");
    svg += legend(left + large_width + 26, large_top + 12);
    for (std::size_t set = 0; set < sets.size(); ++set) svg += small_row(sweep, range, set, sets[set]);
    return svg + "</svg>\n";
}

}  // namespace hanei
