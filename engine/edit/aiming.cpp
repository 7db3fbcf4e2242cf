#include "engine/edit/aiming.h"

#include "engine/edit/intensity_of.h"
#include "engine/scene/placement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei {
namespace {

constexpr double pi = std::numbers::pi;
constexpr Vec3 nadir{0.0, 0.0, -1.0};
constexpr double upright = 1e-6;  // of a unit vector: less sideways than this is straight up or down

double within_half_a_turn(double angle) { return std::remainder(angle, 2.0 * pi); }

/// The angle, of the two with x sin t + z cos t = wished, that is nearer to 0; the one of the greatest
/// or least sum where there is none.
double angle_for(double x, double z, double wished) {
    const double reach = std::hypot(x, z);
    if (!(reach > 0.0)) return 0.0;
    const double middle = std::atan2(x, z);
    const double half = std::acos(std::clamp(wished / reach, -1.0, 1.0));
    const double one = within_half_a_turn(middle + half), other = within_half_a_turn(middle - half);
    constexpr double as_good = 1e-9;
    if (std::abs(std::abs(one) - std::abs(other)) < as_good) return std::max(one, other);
    return std::abs(one) < std::abs(other) ? one : other;
}

}  // namespace

Vec3 main_beam(const Scene& scene, const Luminaire& luminaire) {
    const IntensityOf candela(scene, luminaire);
    constexpr int planes = 72, rings = 90;  // 5 and 2 degrees
    std::vector<double> found;
    std::vector<Vec3> directions;
    double peak = 0.0;
    for (int ring = 0; ring < rings; ++ring) {
        const double gamma = (ring + 0.5) * pi / rings;
        for (int plane = 0; plane < planes; ++plane) {
            const double c = 2.0 * pi * plane / planes;
            directions.push_back({std::sin(gamma) * std::cos(c), std::sin(gamma) * std::sin(c), -std::cos(gamma)});
            found.push_back(candela(directions.back()));
            peak = std::max(peak, found.back());
        }
    }
    if (!(peak > 0.0)) return nadir;
    Vec3 sum{0.0};
    double parts = 0.0;
    for (std::size_t k = 0; k < directions.size(); ++k) {
        const double sine = std::sqrt(std::max(0.0, 1.0 - directions[k].z * directions[k].z));
        const double weight = sine * std::pow(found[k] / peak, 8.0);
        sum += weight * directions[k];
        parts += weight;
    }
    constexpr double crowded = 0.1, nearly_plumb = 0.035;  // 2 degrees
    if (glm::length(sum) < crowded * parts) return nadir;
    const Vec3 beam = glm::normalize(sum);
    return std::hypot(beam.x, beam.y) < nearly_plumb ? Vec3(0.0, 0.0, beam.z < 0.0 ? -1.0 : 1.0) : beam;
}

Vec3 beam_in_scene(const Scene& scene, const Luminaire& luminaire) {
    return placement(luminaire).direction(main_beam(scene, luminaire));
}

Luminaire aimed(const Scene& scene, Luminaire luminaire, const Vec3& target) {
    const Vec3 way = target - luminaire.position;
    const double distance = glm::length(way);
    constexpr double own_place = 1e-6;  // m
    if (!(distance > own_place) || !std::isfinite(distance)) return luminaire;
    const Vec3 wished = way / distance;
    const Vec3 beam = main_beam(scene, luminaire);
    luminaire.tilt = luminaire.roll = 0.0;
    const bool by_roll = std::abs(beam.y) > std::abs(beam.x);
    const double reach = by_roll ? std::hypot(beam.y, beam.z) : std::hypot(beam.x, beam.z);
    if (std::abs(wished.z) > reach) {
        // roll the beam into plane C0-C180 first, then tilt it there
        luminaire.roll = -std::atan2(beam.y, -beam.z);
        luminaire.tilt = angle_for(beam.x, -std::hypot(beam.y, beam.z), wished.z);
    } else if (by_roll) {
        luminaire.roll = angle_for(beam.y, beam.z, wished.z);
    } else {
        luminaire.tilt = angle_for(beam.x, beam.z, wished.z);
    }
    if (std::hypot(wished.x, wished.y) < upright) return luminaire;
    Luminaire unturned = luminaire;
    unturned.yaw = 0.0;
    const Vec3 turned = placement(unturned).direction(beam);
    luminaire.yaw = within_half_a_turn(std::atan2(wished.y, wished.x) - std::atan2(turned.y, turned.x));
    return luminaire;
}

Scene aimed(Scene scene, std::span<const ObjectId> luminaires, const Vec3& target) {
    for (Luminaire& luminaire : scene.luminaires)
        if (std::find(luminaires.begin(), luminaires.end(), luminaire.id) != luminaires.end())
            luminaire = aimed(scene, luminaire, target);
    return scene;
}

}  // namespace hanei
