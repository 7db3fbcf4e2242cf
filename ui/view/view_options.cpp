#include "ui/view/view_options.h"

#include "engine/geometry/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hanei {
namespace {

constexpr std::array step_digits{1.0, 1.5, 2.0, 3.0, 5.0, 7.5};
constexpr double dark_share = 0.04;      // of the area: undersides and gaps that hardly show
constexpr double bright_share = 0.997;   // desk tops are less than a hundredth of a room's faces, and matter most
constexpr double widest_range = 100.0;   // high / low: more and desks and floor share one colour
constexpr double narrowest_range = 5.0;  // less and the mesh's own errors become colours
constexpr double deepest_step = 1e-4;    // of the range's top: where the steps of a range from 0 begin
constexpr double step_tolerance = 1e-9;  // relative: 0.1 + 0.2 is still the step 0.3

double step_at(int decade, std::size_t digit) {
    // A division keeps steps under 1 lx the nearest double to what they are written as.
    return decade >= 0 ? step_digits[digit] * std::pow(10.0, decade) : step_digits[digit] / std::pow(10.0, -decade);
}

double step_below(double lux) {
    const int decade = static_cast<int>(std::floor(std::log10(lux) + step_tolerance));
    double found = step_at(decade, 0);
    for (std::size_t digit = 0; digit < step_digits.size(); ++digit) {
        if (step_at(decade, digit) <= lux * (1.0 + step_tolerance)) found = step_at(decade, digit);
    }
    return found;
}

double step_above(double lux) {
    const int decade = static_cast<int>(std::floor(std::log10(lux)));
    for (std::size_t digit = 0; digit < step_digits.size(); ++digit) {
        if (step_at(decade, digit) >= lux * (1.0 - step_tolerance)) return step_at(decade, digit);
    }
    return step_at(decade + 1, 0);
}

/// Multiples of a round figure, some ten.
std::vector<double> even_steps(const LuxRange& range) {
    std::vector<double> steps;
    const double span = range.high - range.low;
    if (!(span > 0.0) || !std::isfinite(span)) return steps;
    const double decade = std::pow(10.0, std::floor(std::log10(span / 5.0)));
    const double step = span / decade > 25.0 ? 5.0 * decade : span / decade > 12.0 ? 2.0 * decade : decade;
    const double last = std::floor(range.high / step + step_tolerance);
    for (double k = std::max(1.0, std::ceil(range.low / step - step_tolerance)); k <= last; k += 1.0)
        steps.push_back(k * step);
    return steps;
}

struct Sample {
    double lux = 0.0;
    double area = 0.0;
};

std::vector<Sample> cell_samples(const Solution& solution) {
    std::vector<Sample> samples;
    const DisplayMesh& display = *solution.display;
    for (const DisplayCell& cell : display.cells) {
        double lux = 0.0;
        Polygon outline;
        for (const std::uint32_t corner : cell.corner) {
            const DisplayVertex& vertex = display.vertices[corner];
            lux += 0.25 * static_cast<double>(value_of(vertex, LightPart::total));
            outline.push_back(vertex.position);
        }
        samples.push_back({lux, glm::length(vector_area(outline))});
    }
    return samples;
}

double percentile(const std::vector<Sample>& sorted, double share) {
    double whole = 0.0;
    for (const Sample& sample : sorted) whole += sample.area;
    double passed = 0.0;
    for (const Sample& sample : sorted) {
        passed += sample.area;
        if (passed >= share * whole) return sample.lux;
    }
    return sorted.back().lux;
}

}  // namespace

std::string_view name_of(LightPart part) {
    switch (part) {
        case LightPart::total:
            return "total";
        case LightPart::direct:
            return "direct";
        case LightPart::interreflected:
            return "interreflected";
        case LightPart::unshadowed:
            return "unshadowed";
    }
    return "";
}

std::string_view name_of(Scale scale) { return scale == Scale::photo ? "photo" : "false-colour"; }

std::string_view name_of(ColourSteps steps) {
    switch (steps) {
        case ColourSteps::logarithmic:
            return "logarithmic";
        case ColourSteps::linear:
            return "linear";
        case ColourSteps::standard_steps:
            return "EN 12464-1 steps";
    }
    return "";
}

float value_of(const DisplayVertex& vertex, LightPart part) {
    switch (part) {
        case LightPart::total:
            return vertex.direct + vertex.interreflected;
        case LightPart::direct:
            return vertex.direct;
        case LightPart::interreflected:
            return vertex.interreflected;
        case LightPart::unshadowed:
            return vertex.unshadowed;
    }
    return 0.0F;
}

bool has_part(const Solution& solution, LightPart part) {
    return solution.display != nullptr && (part != LightPart::unshadowed || solution.display->has_unshadowed);
}

LuxRange suggested_range(const Solution& solution) {
    if (solution.display == nullptr || solution.display->cells.empty()) return {};
    std::vector<Sample> samples = cell_samples(solution);
    std::stable_sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.lux < b.lux; });
    const double bright = percentile(samples, bright_share);
    if (!(bright > 0.0) || !std::isfinite(bright)) return {};
    const double high = step_above(bright);
    const double dark = std::clamp(percentile(samples, dark_share), high / widest_range, high / narrowest_range);
    return {step_below(dark), high};
}

std::vector<double> standard_steps(const LuxRange& range) {
    std::vector<double> steps;
    if (!(range.high > range.low) || !(range.high > 0.0) || !std::isfinite(range.high)) return steps;
    const double low = std::max(range.low, deepest_step * range.high);
    const int first = static_cast<int>(std::floor(std::log10(low))) - 1;
    const int last = static_cast<int>(std::ceil(std::log10(range.high)));
    for (int decade = first; decade <= last; ++decade) {
        for (std::size_t digit = 0; digit < step_digits.size(); ++digit) {
            const double step = step_at(decade, digit);
            const bool within = step >= low * (1.0 - step_tolerance) && step <= range.high * (1.0 + step_tolerance);
            if (within) steps.push_back(step);
        }
    }
    return steps;
}

std::vector<double> scale_steps(const ViewOptions& look) {
    if (look.steps == ColourSteps::standard_steps) return standard_steps(look.range);
    const double unit = lux_in(look.unit);
    const LuxRange shown{look.range.low / unit, look.range.high / unit};
    std::vector<double> steps = look.steps == ColourSteps::linear ? even_steps(shown) : standard_steps(shown);
    for (double& step : steps) step *= unit;
    return steps;
}

std::vector<double> isolux_levels(const ViewOptions& look) {
    return look.isolux_levels.empty() ? scale_steps(look) : look.isolux_levels;
}

ViewOptions as_difference(ViewOptions look, double range) {
    look.difference = true;
    look.range = {-range, range};
    look.scale = Scale::false_colour;
    look.isolux = look.grids = look.shadow_classes = false;
    return look;
}

void take_scale(ViewOptions& look, const ColourScale& scale) {
    look.range = {scale.low, scale.high};
    look.steps = scale.steps == "linear" ? ColourSteps::linear
                 : scale.steps == "en"   ? ColourSteps::standard_steps
                                         : ColourSteps::logarithmic;
    look.marks_clipped = scale.marks_clipped;
    look.isolux_levels = scale.isolux;
}

ColourScale scale_of(const ViewOptions& look) {
    ColourScale scale;
    scale.low = look.range.low;
    scale.high = look.range.high;
    scale.steps = look.steps == ColourSteps::linear           ? "linear"
                  : look.steps == ColourSteps::standard_steps ? "en"
                                                              : "log";
    scale.marks_clipped = look.marks_clipped;
    scale.isolux = look.isolux_levels;
    return scale;
}

}  // namespace hanei
