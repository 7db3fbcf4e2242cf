#include "engine/plan/cost_model.h"

#include "engine/base/tiles.h"
#include "engine/geometry/polygon.h"
#include "engine/scene/grid_spacing.h"

#include <algorithm>
#include <cmath>

namespace hanei {

namespace {

// Nanoseconds on one thread, measured on a furnished room of 1500 patches.
constexpr double ns_light_at_a_point = 150.0;  // one contour, unobstructed
constexpr double ns_shadow_test = 400.0;       // culling among bodies, and cutting what is left
constexpr double ns_factor = 40.0;             // one receiver and one patch, half of them culled
constexpr double ns_patch_shadow = 20.0;       // the same past bodies, for every doubling of their number
constexpr double ns_product = 1.0;             // one factor in one reflection
constexpr double points_a_patch = 4.0;         // Gauss points of the mean direct light

double area_of(const Face& face) { return glm::length(vector_area(face.region)); }

}  // namespace

double CostModel::patches_of(double area, double width) { return std::max(1.0, std::round(area / (width * width))); }

double CostModel::direct_ms() const {
    return 1e-6 * ns_light_at_a_point * points_a_patch * receivers * luminaires / threads;
}
double CostModel::direct_occlusion_ms() const {
    return 1e-6 * ns_shadow_test * std::log2(2.0 + obstacles) * points_a_patch * receivers * luminaires / threads;
}
double CostModel::factors_ms() const { return 1e-6 * ns_factor * receivers * patches / threads; }
double CostModel::patch_occlusion_ms() const {
    return 1e-6 * ns_patch_shadow * std::log2(2.0 + obstacles) * receivers * patches / threads;
}
double CostModel::bounces_ms(int bounces) const {
    return 1e-6 * ns_product * patches * patches * (2.0 + bounces) / threads;
}

CostModel cost_model(const Scene& scene, const Settings& settings, std::span<const Face> faces) {
    CostModel model;
    model.width = settings.max_patch;
    for (const Face& face : faces) model.patches += CostModel::patches_of(area_of(face), model.width);
    model.receivers = model.patches + static_cast<double>(scene.points.size());
    for (const CalculationGrid& grid : scene.grids) {
        if (!(grid.spacing > 0.0)) continue;
        model.receivers += grid_points(grid);
    }
    model.luminaires = static_cast<double>(scene.luminaires.size());
    model.obstacles = static_cast<double>(solids_of(scene).size() + scene.surfaces.size());
    model.threads = settings.threads > 0 ? settings.threads : hardware_threads();
    return model;
}

}  // namespace hanei
