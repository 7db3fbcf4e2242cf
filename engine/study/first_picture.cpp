#include "engine/study/first_picture.h"

#include "engine/scene/colour.h"

#include <algorithm>

namespace hanei {

namespace {

constexpr double wide = 2.5;  // times the patch width: a sixth of the patches

}  // namespace

LightOfSurfaces light_at_vertices(const Level& level, const LevelAnswer& answer) {
    LightOfSurfaces light{level.vertex_values(mixed(answer.parts, &SideLight::interreflected)), {}, {}};
    const bool coloured =
        std::any_of(answer.parts.begin(), answer.parts.end(), [](const MixPart& part) { return part.band > 0; });
    for (int band = 0; coloured && band < colour_bands; ++band)
        light.bands.push_back(level.vertex_values(mixed_band(answer.parts, band, &SideLight::interreflected)));
    return light;
}

std::optional<FirstPicture::Made> FirstPicture::make(const LevelInput& input, const Work& work, StageClock& clock) {
    level_.cut(*input.scene, wide * input.settings->max_patch, input.settings->method, input.plan->black);
    const auto answer = level_.solve(input, work, clock);
    if (!answer) return std::nullopt;
    clock.enter(Stage::refining);
    DisplayInput drawn;
    drawn.scene = input.scene;
    drawn.mesh = level_.now().mesh;
    drawn.occluders = input.occluders;
    drawn.accuracy = input.direct_accuracy;
    drawn.finest = 1;
    if (!display_.update(drawn, work)) return std::nullopt;
    Made made{drawn.mesh, nullptr, light_at_vertices(level_, *answer), display_.flux()};
    made.display = display_.dressed(made.light);
    return made;
}

}  // namespace hanei
