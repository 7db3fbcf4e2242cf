#include "engine/plan/direct_changes.h"

#include "engine/geometry/body_shape.h"
#include "engine/plan/direct_ceiling.h"
#include "engine/plan/measured_openings.h"
#include "engine/plan/places.h"
#include "engine/scene/dimmers.h"
#include "engine/scene/intensity.h"
#include "engine/scene/placement.h"
#include "engine/scene/point_certificate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>

namespace hanei {
namespace {

/// What may stand in the way, in its box.
struct Obstacle {
    Box box;
    ObjectId object;
};

Obstacle around(std::span<const Vec3> places, ObjectId object) {
    Obstacle obstacle{{places.front(), places.front()}, object};
    for (const Vec3& place : places) obstacle.box.include(place);
    return obstacle;
}

std::vector<Obstacle> obstacles_in(const Scene& scene) {
    std::vector<Obstacle> obstacles;
    for (const Shell& shell : shells_of(scene))
        if (!shell.vertices.empty()) obstacles.push_back(around(shell.vertices, shell.object));
    for (const Face& face : sheets_in_the_way(scene)) obstacles.push_back(around(face.region.outline, face.ref.object));
    for (const Luminaire& luminaire : scene.luminaires)
        if (luminaire.opaque)
            obstacles.push_back(around(DirectCeiling(scene, luminaire).shining().corners, luminaire.id));
    return obstacles;
}

bool overlap(const Box& a, const Box& b) {
    return glm::all(glm::lessThanEqual(a.low, b.high)) && glm::all(glm::lessThanEqual(b.low, a.high));
}

/// A measured luminaire whose opening has extent, and what shining from its middle instead costs at most.
struct OfExtent {
    DirectCeiling from_middle;
    const Photometry* photometry;
    Placement placement;
    std::shared_ptr<const PointCertificate> certificate;
};

/// A luminaire's light as far as bounds go.
struct BoundedLight {
    double output = 0.0;  ///< share of full output
    ObjectId luminaire;
    DirectCeiling ceiling;
    std::optional<OfExtent> opening;
};

std::vector<BoundedLight> bounded_lights(const Scene& scene) {
    std::vector<BoundedLight> lights;
    std::map<std::pair<ObjectId, double>, std::shared_ptr<const PointCertificate>> certificates;
    for (const Luminaire& luminaire : scene.luminaires) {
        const double output = dimming_of(scene, luminaire) * scene.maintenance_factor;
        if (!(output > 0.0)) continue;
        BoundedLight light{output, luminaire.id, DirectCeiling(scene, luminaire), std::nullopt};
        if (const auto measured = measured_opening_of(scene, luminaire)) {
            Luminaire point = luminaire;
            point.opening = PointOpening{};
            point.position = placement(luminaire).point(measured->form.centre);
            auto& certificate = certificates[{measured->photometry->id, measured->form.radius}];
            if (!certificate) certificate = std::make_shared<PointCertificate>(*measured->photometry, measured->form);
            light.opening =
                OfExtent{DirectCeiling(scene, point), measured->photometry, placement(luminaire), certificate};
        }
        lights.push_back(std::move(light));
    }
    return lights;
}

/// lx at full output by which the opening's light and that of its middle differ at most, nothing in between.
double certified(const BoundedLight& light, const Receiver& place) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    for (const Vec3& corner : light.ceiling.shining().corners)
        if (!(glm::dot(corner - place.position, place.normal) > 0.0)) return infinite;
    const OfExtent& opening = *light.opening;
    const Vec3 away = place.position - opening.from_middle.shining().centre, local = away * opening.placement.rotation;
    const double distance = glm::length(away), peak = peak_intensity(*opening.photometry).value;
    if (!(distance > 2.0 * opening.certificate->opening().radius) || !(peak > 0.0)) return infinite;
    const double candela = opening.certificate->error(local, distance, intensity(*opening.photometry, local).value,
                                                      -glm::dot(away, place.normal) / distance);
    return light.ceiling.intensity() / peak * candela / (distance * distance);
}

}  // namespace

DirectChanges direct_changes(const Scene& scene, std::span<const Receiver> places) {
    constexpr std::size_t most_obstacles = 5000;
    const std::vector<Obstacle> obstacles = obstacles_in(scene);
    const std::vector<BoundedLight> lights = bounded_lights(scene);
    const auto may_be_hidden = [&](const BoundedLight& light, const Vec3& place) {
        if (obstacles.size() > most_obstacles) return true;
        const CeilingCell& opening = light.ceiling.shining();
        Box between{opening.low, opening.high};
        between.include(place);
        return std::ranges::any_of(obstacles, [&](const Obstacle& obstacle) {
            return obstacle.object != light.luminaire && overlap(between, obstacle.box);
        });
    };
    const std::vector<double> none(places.size(), 0.0);
    DirectChanges changes{none, none, none};
    for (const BoundedLight& light : lights) {
        const bool has_extent = light.ceiling.shining().radius > 0.0;
        for (std::size_t k = 0; k < places.size(); ++k) {
            const CeilingCell place = cell_at(places[k].position, places[k].normal);
            const double lux = light.output * light.ceiling.on(place);
            const bool hidden = may_be_hidden(light, places[k].position);
            if (hidden) changes.shadows[k] += lux;
            if (hidden && has_extent) changes.penumbra[k] += lux;
            if (!light.opening) continue;
            const double either = std::max(lux, light.output * light.opening->from_middle.on(place));
            changes.openings[k] += hidden ? either : std::min(either, light.output * certified(light, places[k]));
        }
    }
    return changes;
}

}  // namespace hanei
