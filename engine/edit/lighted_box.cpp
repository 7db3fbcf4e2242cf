#include "engine/edit/lighted_box.h"

#include "engine/geometry/polygon.h"
#include "engine/scene/faces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hanei {
namespace {

constexpr double pi = std::numbers::pi;

/// The rectangle of a plan's area and circumference: a square of its area where there is none.
Vec2 equivalent_rectangle(const Room& room) {
    double around = 0.0;
    Vec2 low = room.plan.front(), high = low;
    for (std::size_t k = 0; k < room.plan.size(); ++k) {
        around += glm::length(room.plan[(k + 1) % room.plan.size()] - room.plan[k]);
        low = glm::min(low, room.plan[k]);
        high = glm::max(high, room.plan[k]);
    }
    const double area = std::abs(signed_area(room.plan)), half = 0.25 * around;
    const double root = std::sqrt(std::max(0.0, half * half - area));
    Vec2 sides = half * half > area ? Vec2(half + root, half - root) : Vec2(std::sqrt(area));
    const Vec2 bounds = high - low;
    if (bounds.y > bounds.x) std::swap(sides.x, sides.y);
    return sides;
}

double reflectance_of(const Scene& scene, ObjectId material) {
    const Material* const found = find_material(scene, material);
    return found ? found->reflectance : 0.0;
}

/// Of the walls on the whole, by their lengths.
double wall_reflectance(const Scene& scene, const Room& room) {
    double sum = 0.0, around = 0.0;
    for (std::size_t k = 0; k < room.plan.size(); ++k) {
        const double length = glm::length(room.plan[(k + 1) % room.plan.size()] - room.plan[k]);
        const ObjectId material = k < room.wall_materials.size() ? room.wall_materials[k] : ObjectId{};
        sum += length * reflectance_of(scene, material);
        around += length;
    }
    return around > 0.0 ? sum / around : 0.0;
}

}  // namespace

LightedBox::LightedBox(const Scene& scene, const Luminaire& luminaire, const LumenWish& wish)
    : candela_(scene, luminaire), turned_(placement(luminaire)), border_(wish.border) {
    const Room& room = *scene.room;
    sides_ = equivalent_rectangle(room);
    top_ = room.height;
    plane_ = wish.working_plane;
    lamp_ = luminaire.position.z - room.floor_height;
    reflectances_ = {reflectance_of(scene, room.floor_material), reflectance_of(scene, room.ceiling_material),
                     wall_reflectance(scene, room)};
    std::vector<double> levels{0.0, plane_, lamp_, top_};
    std::sort(levels.begin(), levels.end());
    constexpr double band = 0.4, same = 1e-9;  // m
    for (const double level : levels) {
        if (borders_.empty()) borders_.push_back(level);
        const double from = borders_.back(), gap = level - from;
        if (gap <= same) continue;
        const int parts = static_cast<int>(std::ceil(gap / band));
        for (int k = 1; k < parts; ++k) borders_.push_back(from + gap * k / parts);
        borders_.push_back(level);
    }
    shoot();
}

LightedBox::Light LightedBox::from(const std::vector<Vec2>& places) const {
    BoxBalance::Direct direct;
    const BoxBalance balance(sides_.x, sides_.y, borders_);
    direct.bands.assign(balance.bands(), 0.0);
    Light light;
    for (const Vec2& place : places)
        for (const Beam& beam : beams_) land(beam, place, 1.0 / static_cast<double>(places.size()), direct, light);
    light.reflected = balance.reflected_through(plane_, direct, reflectances_);
    light.direct_lux = direct_within_border(places);
    return light;
}

/// The luminaire's flux in beams, each of its share of the sphere.
void LightedBox::shoot() {
    constexpr int planes = 72, rings = 90;
    double total = 0.0;
    for (int ring = 0; ring < rings; ++ring) {
        const double from = ring * pi / rings, to = (ring + 1) * pi / rings, gamma = 0.5 * (from + to);
        const double solid_angle = (std::cos(from) - std::cos(to)) * 2.0 * pi / planes;
        for (int plane = 0; plane < planes; ++plane) {
            const double c = 2.0 * pi * (plane + 0.5) / planes;
            const Vec3 own{std::sin(gamma) * std::cos(c), std::sin(gamma) * std::sin(c), -std::cos(gamma)};
            const double flux = candela_(own) * solid_angle;
            if (!(flux > 0.0)) continue;
            beams_.push_back({turned_.direction(own), flux});
            total += flux;
        }
    }
    // as much as the table holds: peaks between the beams are in their sum
    for (Beam& beam : beams_) beam.flux *= total > 0.0 ? candela_.flux() / total : 0.0;
}

void LightedBox::land(const Beam& beam, const Vec2& place, double share, BoxBalance::Direct& direct,
                      Light& light) const {
    constexpr double never = std::numeric_limits<double>::infinity();
    const auto until = [&](double at, double by, double low, double high) {
        return by > 0.0 ? (high - at) / by : by < 0.0 ? (low - at) / by : never;
    };
    const Vec3& e = beam.direction;
    const double wall = std::min(until(place.x, e.x, 0.0, sides_.x), until(place.y, e.y, 0.0, sides_.y));
    const double level = until(lamp_, e.z, 0.0, top_);
    const double flux = share * beam.flux;
    if (e.z < 0.0 && lamp_ > plane_ && (plane_ - lamp_) / e.z <= wall) light.to_plane += flux;
    if (level <= wall) {
        (e.z > 0.0 ? direct.ceiling : direct.floor) += flux;
        return;
    }
    const double at = std::clamp(lamp_ + wall * e.z, 0.0, top_);
    const auto above = std::upper_bound(borders_.begin() + 1, borders_.end() - 1, at);
    direct.bands[static_cast<std::size_t>(above - borders_.begin() - 1)] += flux;
}

/// Illuminance from the places on points all over the plane within its border.
double LightedBox::direct_within_border(const std::vector<Vec2>& places) const {
    const double border = std::min(border_, 0.2 * std::min(sides_.x, sides_.y));
    constexpr int points = 24;
    double sum = 0.0;
    for (int column = 0; column < points; ++column) {
        for (int row = 0; row < points; ++row) {
            const Vec2 share((column + 0.5) / points, (row + 0.5) / points);
            const Vec2 at = Vec2(border) + share * (sides_ - Vec2(2.0 * border));
            for (const Vec2& place : places) sum += lux(Vec3(at - place, plane_ - lamp_));
        }
    }
    return sum / (points * points * static_cast<double>(places.size()));
}

double LightedBox::lux(const Vec3& way) const {
    const double distance = glm::length(way);
    if (!(distance > 0.0) || way.z >= 0.0) return 0.0;
    const Vec3 own = glm::transpose(turned_.rotation) * (way / distance);
    return candela_(own) * -way.z / (distance * distance * distance);
}

}  // namespace hanei
