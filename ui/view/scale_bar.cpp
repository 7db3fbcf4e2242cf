#include "ui/view/scale_bar.h"

#include <array>
#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

constexpr double inch = 0.0254;  // m

struct Round {
    double figure = 1.0;
    int fields = 2;
};

/// The greatest of 1, 2, 5, 10, ... that is no greater. Fields are round lengths as well.
Round round_below(double most) {
    const double decade = std::pow(10.0, std::floor(std::log10(most * (1.0 + 1e-9))));
    for (const auto& [factor, fields] : {std::pair{5.0, 5}, std::pair{2.0, 2}, std::pair{1.0, 2}}) {
        if (factor * decade <= most * (1.0 + 1e-9)) return {factor * decade, fields};
    }
    return {0.5 * decade, 5};  // the logarithm was rounded up
}

ScaleBar in_feet(double most) {
    if (most >= 12.0 * inch) {
        const Round feet = round_below(most / (12.0 * inch));
        return {feet.figure * 12.0 * inch, 0.0, feet.fields, fmt::format("{:g} ft", feet.figure)};
    }
    for (const double inches : {6.0, 2.0}) {
        if (inches * inch <= most) return {inches * inch, 0.0, 2, fmt::format("{:g} in", inches)};
    }
    const Round inches = round_below(most / inch);
    return {inches.figure * inch, 0.0, inches.fields, fmt::format("{:g} in", inches.figure)};
}

ScaleBar in_metric(double most, LengthUnit unit) {
    const double worth = unit == LengthUnit::metre ? 1.0 : unit == LengthUnit::centimetre ? 0.01 : 0.001;
    const char* const word = unit == LengthUnit::metre ? "m" : unit == LengthUnit::centimetre ? "cm" : "mm";
    const Round round = round_below(most / worth);
    return {round.figure * worth, 0.0, round.fields, fmt::format("{} {}", round.figure, word)};
}

}  // namespace

std::optional<ScaleBar> scale_bar(const Camera& camera, double picture_height, double most, LengthUnit unit) {
    if (!camera.orthographic) return std::nullopt;
    const double metre = picture_height / picture_height_at(camera, camera.target);  // pixels
    const double longest = most / metre;
    if (!std::isfinite(longest) || !(longest > 1e-6) || longest > 1e7) return std::nullopt;
    ScaleBar bar = unit == LengthUnit::feet_inches ? in_feet(longest) : in_metric(longest, unit);
    bar.pixels = bar.metres * metre;
    return bar;
}

}  // namespace hanei
