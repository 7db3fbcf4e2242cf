#include "engine/edit/hanging.h"

#include "engine/edit/luminaire_edits.h"
#include "engine/scene/colour.h"

#include <algorithm>

namespace hanei {
namespace {

constexpr double side_by_side = 0.3;  // m, between the openings of neighbours
constexpr double below_the_ceiling = 0.05;

double ceiling_of(const Scene& scene) {
    return scene.room ? scene.room->floor_height + scene.room->height : 2.8;  // without a room, an office's height
}

double width_of(const Photometry& photometry) { return std::max(0.1, photometry.opening.extent_0); }

/// Where a row of this length begins so that it lies about `middle`, and within the room if it fits.
double row_start(double middle, double length, double low, double high) {
    const double wished = middle - 0.5 * length;
    if (length > high - low) return wished;
    return std::clamp(wished, low, high - length);
}

}  // namespace

PlanBounds bounds_of_plan(const Scene& scene) {
    PlanBounds bounds{{0.0, 0.0}, {6.0, 4.0}};
    if (!scene.room || scene.room->plan.empty()) return bounds;
    bounds.low = bounds.high = scene.room->plan.front();
    for (const Vec2& corner : scene.room->plan) {
        bounds.low = glm::min(bounds.low, corner);
        bounds.high = glm::max(bounds.high, corner);
    }
    return bounds;
}

Added with_measured_luminaires(Scene scene, std::vector<Photometry> photometries, Vec2 place) {
    const PlanBounds plan = bounds_of_plan(scene);
    double length = -side_by_side;
    for (const Photometry& photometry : photometries) length += width_of(photometry) + side_by_side;
    double x = photometries.size() == 1 ? place.x - 0.5 * length : row_start(place.x, length, plan.low.x, plan.high.x);
    ObjectId last;
    for (Photometry& photometry : photometries) {
        Luminaire luminaire;
        luminaire.id = last = scene.new_id();
        luminaire.name = (photometry.name.empty() ? "Luminaire" : photometry.name) + " " +
                         std::to_string(scene.luminaires.size() + 1);
        const double floor = scene.room ? scene.room->floor_height : 0.0;
        const double z = std::max(floor, ceiling_of(scene) - photometry.opening.height - below_the_ceiling);
        luminaire.position = {x + 0.5 * width_of(photometry), place.y, z};
        if (photometries.size() == 1) luminaire.position.x = place.x;
        x += width_of(photometry) + side_by_side;
        luminaire.opening = MeasuredOpening{};
        luminaire.output = AsMeasured{};
        luminaire.colour_temperature = stated_colour_temperature(photometry).value_or(0.0);
        luminaire.distribution = Measured{photometry_in(scene, std::move(photometry))};
        scene.luminaires.push_back(std::move(luminaire));
    }
    return {std::move(scene), last};
}

}  // namespace hanei
