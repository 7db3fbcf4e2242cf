/// Studies that tests run, and what they compare of the answers.
#pragma once

#include "engine/study/study.h"
#include "tests/box_room.h"

#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace hanei::test {

inline SceneSnapshot snapshot(Scene scene) { return std::make_shared<const Scene>(std::move(scene)); }

inline Settings coarse_settings(Method method = Method::patch) {
    Settings settings;
    settings.method = method;
    settings.max_patch = 0.8;
    settings.accuracy = 1e-6;
    settings.bounces = is_of_the_paper(method) ? 4 : 1000;
    settings.threads = 1;
    return settings;
}

/// Every figure of an answer, to be compared to the bit.
inline std::vector<double> values_of(const Solution& solution) {
    std::vector<double> values;
    const auto add = [&](const PointValue& value) {
        const ErrorBar& error = value.error;
        values.insert(values.end(), {value.direct.value, value.interreflected.value, error.iteration, error.mesh,
                                     error.skipped, error.sampling, value.inside_solid ? 1.0 : 0.0});
    };
    for (const PointResult& point : solution.points) add(point.value);
    for (const GridResult& grid : solution.grids)
        for (const PointResult& point : grid.points) add(point.value);
    for (const auto& [face, mean] : solution.face_means) add(mean);
    for (const auto* list : {&solution.patch_direct, &solution.patch_interreflected, &solution.exitance,
                             &solution.exitance_half_width, &solution.coarse_exitance})
        values.insert(values.end(), list->begin(), list->end());
    const EnergyBalance& energy = solution.energy;
    values.insert(values.end(), {energy.emitted, energy.absorbed, energy.escaped, solution.iteration_bound,
                                 solution.greatest_row_sum, static_cast<double>(solution.bounces)});
    if (!solution.display) return values;
    for (const DisplayVertex& vertex : solution.display->vertices)
        values.insert(values.end(), {vertex.direct, vertex.interreflected, vertex.unshadowed});
    for (const std::array<float, 3>& bands : solution.display->tinted)
        values.insert(values.end(), bands.begin(), bands.end());
    return values;
}

/// A table of a narrow beam, its opening a panel.
inline Photometry beam(Scene& scene, double exponent) {
    Photometry photometry;
    photometry.id = scene.new_id();
    photometry.symmetry = PhotometricSymmetry::rotational;
    photometry.horizontal_deg = {0.0};
    for (int gamma = 0; gamma <= 90; gamma += 5) {
        photometry.vertical_deg.push_back(gamma);
        photometry.candela.push_back(1000.0 * std::pow(std::cos(gamma * std::numbers::pi / 180.0), exponent));
    }
    photometry.candela.back() = 0.0;
    photometry.absolute = true;
    photometry.opening = {OpeningShape::rectangle, 1.2, 0.3, 0.0};
    return photometry;
}

/// The small office with two more luminaires, both of the group "wall", one of them measured, and a
/// grid on the desk. Surfaces and lamps are neutral.
inline Scene grouped_office() {
    Scene scene = small_office();
    for (const double x : {2.0, 4.0}) {
        scene.luminaires.push_back(panel(scene, {x, 0.6, 2.6}, {1.0, 0.2}, 1500.0));
        if (scene.control_groups.empty()) scene.control_groups.push_back({scene.new_id(), "wall", 1.0, 0.0, {}});
        scene.luminaires.back().group = scene.control_groups.back().id;
    }
    scene.photometries.push_back(beam(scene, 3.0));
    scene.luminaires.back().opening = MeasuredOpening{};
    scene.luminaires.back().distribution = Measured{scene.photometries.front().id};
    scene.luminaires.back().output = AsMeasured{};
    CalculationGrid grid;
    grid.id = scene.new_id();
    grid.corner = {1.4, 1.7, 0.75};
    grid.along = {1.2, 0.0, 0.0};
    grid.across = {0.0, 0.6, 0.0};
    grid.spacing = 0.3;
    scene.grids.push_back(grid);
    return scene;
}

}  // namespace hanei::test
