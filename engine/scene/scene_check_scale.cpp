#include "engine/scene/scene_findings.h"

#include <algorithm>
#include <array>

namespace hanei {
namespace {

constexpr double greatest_lux = 1e7;     // ten times what an operating lamp gives
constexpr std::size_t most_levels = 64;  // lines that a picture can draw
constexpr std::array<std::string_view, 3> known_steps{"log", "linear", "en"};

void check_levels(ObjectFindings& object, const std::vector<double>& levels) {
    if (levels.size() > most_levels)
        object.error("isolux_lx", "found " + std::to_string(levels.size()) + " levels, allowed are " +
                                      std::to_string(most_levels) + " at most");
    double last = 0.0;
    for (std::size_t k = 0; k < levels.size(); ++k) {
        const std::string field = "isolux_lx[" + std::to_string(k) + "]";
        if (!object.finite(field, {levels[k]})) return;
        if (!(levels[k] > last && levels[k] <= greatest_lux)) {
            object.error(field, "found " + figure(levels[k]) + ", allowed are rising levels above 0 lx, " +
                                    figure(greatest_lux) + " lx at most");
            return;
        }
        last = levels[k];
    }
}

}  // namespace

void check_colour_scale(SceneChecks& checks) {
    if (!checks.scene.colour_scale) return;
    const ColourScale& scale = *checks.scene.colour_scale;
    ObjectFindings object(checks.findings, "colour_scale", "colour scale", "", {});
    object.within("low_lx", scale.low, 0.0, greatest_lux);
    object.within("high_lx", scale.high, 0.0, greatest_lux);
    if (!(scale.low < scale.high))
        object.error("high_lx", "found " + figure(scale.high) + ", allowed is more than the low end, " +
                                    figure(scale.low) + " lx");
    if (std::find(known_steps.begin(), known_steps.end(), scale.steps) == known_steps.end())
        object.error("steps", "found \"" + scale.steps + "\", allowed are \"log\", \"linear\" and \"en\"");
    check_levels(object, scale.isolux);
}

}  // namespace hanei
