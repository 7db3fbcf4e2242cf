#include "engine/edit/lumen_method.h"

#include "engine/edit/arrangements.h"
#include "engine/edit/box_balance.h"
#include "engine/edit/intensity_of.h"
#include "engine/edit/luminaire_edits.h"
#include "engine/geometry/polygon.h"
#include "engine/scene/faces.h"
#include "engine/scene/placement.h"
#include "engine/scene/suspension.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

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

/// An empty box of a room with one luminaire's light in it.
class LightedBox {
public:
    LightedBox(const Scene& scene, const Luminaire& luminaire, const LumenWish& wish)
        : candela_(scene, luminaire), turned_(placement(luminaire)), wish_(wish) {
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

    double height() const { return lamp_ - plane_; }
    double flux() const { return candela_.flux(); }
    Vec2 sides() const { return sides_; }
    double area() const { return sides_.x * sides_.y; }

    struct Light {
        double to_plane = 0.0;    ///< lm straight through the whole working plane, of one luminaire
        double reflected = 0.0;   ///< lm that reach it by way of surfaces
        double direct_lux = 0.0;  ///< mean over the plane within its border, of one luminaire
    };
    /// Of luminaires at these places (x and y from a corner of the box), on the mean.
    Light from(const std::vector<Vec2>& places) const {
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

private:
    struct Beam {
        Vec3 direction{0.0};
        double flux = 0.0;
    };

    /// The luminaire's flux in beams, each of its share of the sphere.
    void shoot() {
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

    void land(const Beam& beam, const Vec2& place, double share, BoxBalance::Direct& direct, Light& light) const {
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
    double direct_within_border(const std::vector<Vec2>& places) const {
        const double border = std::min(wish_.border, 0.2 * std::min(sides_.x, sides_.y));
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
    double lux(const Vec3& way) const {
        const double distance = glm::length(way);
        if (!(distance > 0.0) || way.z >= 0.0) return 0.0;
        const Vec3 own = glm::transpose(turned_.rotation) * (way / distance);
        return candela_(own) * -way.z / (distance * distance * distance);
    }

    IntensityOf candela_;
    Placement turned_;
    LumenWish wish_;
    Vec2 sides_{1.0};
    double top_ = 0.0, plane_ = 0.0, lamp_ = 0.0;
    BoxBalance::Reflectances reflectances_;
    std::vector<double> borders_;
    std::vector<Beam> beams_;
};

std::vector<Vec2> field_places(const Vec2& sides, int columns, int rows) {
    std::vector<Vec2> places;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            places.push_back({(column + 0.5) / columns * sides.x, (row + 0.5) / rows * sides.y});
    return places;
}

constexpr int even_spread = 16;  // places along each side that stand for all places

/// Rows and columns for at least `needed`, the spacing as square and the surplus as small as they can be.
std::array<int, 2> columns_and_rows(const Vec2& sides, int needed) {
    constexpr double weight_of_surplus = 2.0;
    std::array<int, 2> best{needed, 1};
    double least = std::numeric_limits<double>::infinity();
    for (int rows = 1; rows <= std::min(needed, most_in_a_row); ++rows) {
        const int columns = (needed + rows - 1) / rows;
        if (columns > most_in_a_row) continue;
        const double unsquare = std::abs(std::log(sides.x / columns * rows / sides.y));
        const double surplus = static_cast<double>(columns * rows) / needed - 1.0;
        const double cost = unsquare + weight_of_surplus * surplus;
        if (cost < least) {
            least = cost;
            best = {columns, rows};
        }
    }
    return best;
}

/// The luminaire upright at the height of its mounting.
Luminaire as_mounted(const Scene& scene, const Luminaire& luminaire, const MountingWish& mounting) {
    Scene one;
    one.room = scene.room;
    one.photometries = scene.photometries;
    one.luminaires = {luminaire};
    const ObjectId ids[] = {luminaire.id};
    return mounted(std::move(one), ids, mounting).luminaires.front();
}

std::string refusal_of(const Scene& scene, const LumenWish& wish) {
    if (!scene.room || scene.room->plan.size() < 3 || !(std::abs(signed_area(scene.room->plan)) > 0.0))
        return "There is no room to light: draw one first.";
    if (!std::isfinite(wish.target) || !(wish.target > 0.0)) return "The wanted illuminance must be above 0 lx.";
    const bool between = wish.working_plane >= 0.0 && wish.working_plane < scene.room->height;
    return between ? std::string() : std::string("The working plane must lie between the floor and the ceiling.");
}

}  // namespace

double utilization_factor(const Scene& scene, const Luminaire& luminaire, const LumenWish& wish) {
    if (!refusal_of(scene, wish).empty()) return 0.0;
    const LightedBox box(scene, as_mounted(scene, luminaire, wish.mounting), wish);
    if (!(box.flux() > 0.0)) return 0.0;
    const LightedBox::Light light = box.from(field_places(box.sides(), even_spread, even_spread));
    return (light.to_plane + light.reflected) / box.flux();
}

double spacing_criterion(const Scene& scene, const Luminaire& luminaire) {
    constexpr double most = 3.0, step = 0.01;
    const IntensityOf candela(scene, luminaire);
    const auto from = [&](double plane, double gamma) {
        const double sine = std::sin(gamma);
        return candela({sine * std::cos(plane), sine * std::sin(plane), -std::cos(gamma)});
    };
    double least = most;
    for (const double plane : {0.0, 0.5 * pi}) {
        const double below = from(plane, 0.0);
        double reached = 0.0;
        for (double ratio = step; ratio <= most; ratio += step) {
            const double gamma = std::atan(0.5 * ratio);
            const double midway = (from(plane, gamma) + from(plane + pi, gamma)) * std::pow(std::cos(gamma), 3.0);
            if (midway >= below) reached = ratio;
        }
        least = std::min(least, reached);
    }
    return least;
}

LumenAnswer lumen_method(const Scene& scene, const Luminaire& luminaire, const LumenWish& wish) {
    LumenAnswer answer;
    answer.refusal = refusal_of(scene, wish);
    if (!answer.refusal.empty()) return answer;
    const LightedBox box(scene, as_mounted(scene, luminaire, wish.mounting), wish);
    answer.height = box.height();
    if (!(answer.height > 0.0)) answer.refusal = "The luminaires would hang below the working plane: raise them.";
    if (!(box.flux() > 0.0)) answer.refusal = "The luminaire gives no light.";
    if (!answer.refusal.empty()) return answer;

    const double kept = scene.maintenance_factor * luminaire.dimming;
    const auto predict = [&](int columns, int rows) {
        const LightedBox::Light light = box.from(field_places(box.sides(), columns, rows));
        const double share = columns * rows * kept;
        answer.columns = columns;
        answer.rows = rows;
        answer.direct = share * light.direct_lux;
        answer.mean = answer.direct + share * light.reflected / box.area();
        answer.utilization = (light.to_plane + light.reflected) / box.flux();
    };
    predict(wish.columns.value_or(1), wish.rows.value_or(1));
    if (!(answer.mean > 0.0)) {
        answer.refusal = "None of the light reaches the working plane: take another luminaire, or other reflectances.";
        return answer;
    }
    if (!wish.columns || !wish.rows) {
        constexpr int most = 10000;
        const LightedBox::Light even = box.from(field_places(box.sides(), even_spread, even_spread));
        const double one = kept * (even.direct_lux + even.reflected / box.area());
        const double first = one > 0.0 ? wish.target / one : most;
        if (!(first < most)) {
            answer.refusal = "More than 10000 luminaires would be needed: take one of more light.";
            return answer;
        }
        int needed = std::max(1, static_cast<int>(std::ceil(first - 0.02 * first)));
        constexpr double enough = 0.99;
        for (int round = 0; round < 12; ++round) {
            const auto [columns, rows] = columns_and_rows(box.sides(), needed);
            predict(columns, rows);
            if (answer.mean >= enough * wish.target) break;
            needed = std::max(needed, columns * rows) + 1;
        }
    }
    answer.room_index = box.area() / (answer.height * (box.sides().x + box.sides().y));
    const Vec2 spacing{box.sides().x / answer.columns, box.sides().y / answer.rows};
    answer.spacing_to_height = std::max(spacing.x, spacing.y) / answer.height;
    answer.spacing_limit = spacing_criterion(scene, luminaire);
    if (const Photometry* photometry = photometry_of(scene, luminaire))
        answer.watts = answer.count() * std::max(0.0, photometry->input_watts);
    answer.watts_per_m2 = answer.watts / box.area();
    return answer;
}

}  // namespace hanei
