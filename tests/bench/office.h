/// The office that rows and studies are timed in.
#pragma once

#include "engine/mesh/mesh.h"
#include "engine/plan/settings.h"
#include "tests/unit/mesh/sample_scenes.h"

#include <algorithm>
#include <cmath>

namespace hanei::bench {

/// 6 x 4 x 3 m with four tables.
inline Scene room_with_desks() {
    Scene scene = sample::box_room(6.0, 4.0, 3.0);
    for (const double x : {1.5, 4.2}) {
        for (const double y : {1.0, 2.9}) sample::add_table(scene, {x, y, 0.0}, 0.3 * x);
    }
    return scene;
}

/// The same under four panels, with a grid of 24 x 16 points at desk height.
inline Scene lit_office() {
    Scene scene = room_with_desks();
    for (const double x : {1.5, 4.5}) {
        for (const double y : {1.1, 2.9}) {
            Luminaire panel;
            panel.id = scene.new_id();
            panel.position = {x, y, 2.9};
            panel.opening = PolygonOpening{{{{-0.6, -0.15, 0}, {-0.6, 0.15, 0}, {0.6, 0.15, 0}, {0.6, -0.15, 0}}, {}}};
            panel.output = LuminousFlux{3500.0};
            scene.luminaires.push_back(panel);
        }
    }
    CalculationGrid grid;
    grid.id = scene.new_id();
    grid.corner = {0.0, 0.0, 0.75};
    grid.along = {6.0, 0.0, 0.0};
    grid.across = {0.0, 4.0, 0.0};
    grid.spacing = 0.25;
    scene.grids.push_back(grid);
    return scene;
}

/// A patch width by which the scene has about as many unknowns.
inline double width_for(const Scene& scene, Method method, double unknowns) {
    const bool linear = method == Method::linear;
    const double patches = unknowns / (linear ? 4.0 : 1.0);
    double width = std::sqrt(96.0 / patches);
    for (int k = 0; k < 4; ++k) {
        const auto mesh = make_mesh(scene, width, linear ? Grading::crowded : Grading::uniform);
        const double ratio = static_cast<double>(mesh->patches.size()) / patches;
        if (std::abs(ratio - 1.0) < 0.03) break;
        width *= std::sqrt(ratio);
    }
    return std::clamp(width, 0.02, 2.0);
}

}  // namespace hanei::bench
