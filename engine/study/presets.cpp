#include "engine/study/presets.h"

#include "engine/geometry/polygon.h"
#include "engine/scene/faces.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

constexpr double most_unknowns = 30'000.0;  // more are for who sets them by hand

/// Two digits: 0.37 m reads better than 0.371842 m.
double rounded(double width) {
    const double unit = std::pow(10.0, std::floor(std::log10(width)) - 1.0);
    return std::round(width / unit) * unit;
}

/// From some patches a wall downwards, each 1/sqrt(2) of the one before, within what may be set.
std::vector<double> widths_for(const Scene& scene) {
    double area = 0.0;
    for (const Face& face : faces_of(scene)) area += glm::length(vector_area(face.region));
    std::vector<double> widths;
    if (!(area > 0.0) || !std::isfinite(area)) return widths;
    const double widest = 0.2 * std::sqrt(area);
    for (double width = widest; width > widest / 120.0; width /= std::sqrt(2.0))
        widths.push_back(std::clamp(rounded(width), 0.01, 50.0));
    return widths;
}

}  // namespace

std::string_view name_of(Preset preset) {
    constexpr std::string_view names[] = {"draft", "design", "verify"};
    return names[static_cast<std::size_t>(preset)];
}

std::optional<Preset> preset_named(std::string_view name) {
    for (const Preset preset : presets)
        if (name_of(preset) == name) return preset;
    return std::nullopt;
}

double wished_error(Preset preset) {
    constexpr double wishes[] = {0.10, 0.03, 0.01};
    return wishes[static_cast<std::size_t>(preset)];
}

Suggestion settings_for(const Scene& scene, const Settings& from, double wished_share, const Calibration& calibration) {
    const double wish = std::isfinite(wished_share) ? std::clamp(wished_share, least_wish, greatest_wish) : 0.05;
    Settings settings = from;
    settings.bounces = 1000;
    settings.accuracy = 0.1 * wish;  // of the wish: what iterating leaves unknown is not to be seen
    std::optional<Suggestion> soonest, most_exact;
    const std::vector<double> widths = widths_for(scene);
    for (const Method method : {Method::patch, Method::linear}) {
        for (const double width : widths) {
            settings.method = method;
            settings.max_patch = width;
            const ExpectedWork work = expected_work(scene, settings);
            const bool first = width == widths.front();  // faces may be many: then that is what there is
            if (!first && work.unknowns > most_unknowns) break;
            Prediction prediction = calibration.predict(work, method);
            prediction.error = std::max(prediction.error, settings.accuracy);
            const Suggestion suggestion{settings, prediction, prediction.error <= wish};
            if (suggestion.reaches && (!soonest || prediction.ms < soonest->prediction.ms)) soonest = suggestion;
            if (!most_exact || prediction.error < most_exact->prediction.error) most_exact = suggestion;
        }
    }
    if (soonest) return *soonest;
    return most_exact.value_or(Suggestion{from, {}, false});
}

}  // namespace hanei
