#include "engine/edit/mounting.h"

#include "engine/edit/intensity_of.h"
#include "engine/scene/placement.h"
#include "engine/scene/suspension.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hanei {
namespace {

constexpr double flush = 0.005;   // m, below a ceiling, off a wall: opening and surface are two
constexpr double housing = 0.08;  // m, of a luminaire on a ceiling, above its opening
constexpr double quarter = 0.5 * std::numbers::pi;

/// Where the light goes on the whole: sum I(e) e dw over the flux, in the luminaire's frame.
struct Favour {
    Vec3 direction{0.0};
    double upward = 0.0;  ///< share of the flux
};

Favour favour_of(const Scene& scene, const Luminaire& luminaire) {
    const IntensityOf candela(scene, luminaire);
    constexpr int planes = 24, rings = 36;
    Favour favour;
    double total = 0.0;
    for (int ring = 0; ring < rings; ++ring) {
        const double gamma = (ring + 0.5) * std::numbers::pi / rings;
        for (int plane = 0; plane < planes; ++plane) {
            const double c = 2.0 * std::numbers::pi * plane / planes;
            const Vec3 e{std::sin(gamma) * std::cos(c), std::sin(gamma) * std::sin(c), -std::cos(gamma)};
            const double part = candela(e) * std::sin(gamma);
            favour.direction += part * e;
            total += part;
            if (e.z > 0.0) favour.upward += part;
        }
    }
    if (!(total > 0.0)) return {};
    return {favour.direction / total, favour.upward / total};
}

double floor_of(const Room& room) { return room.floor_height; }
double ceiling_of(const Room& room) { return room.floor_height + room.height; }

/// The z that keeps the whole opening within the room; its middle where it does not fit.
double within_room(const Room& room, double z, double reach) {
    const double low = floor_of(room) + reach + flush, high = ceiling_of(room) - reach - flush;
    return low > high ? 0.5 * (low + high) : std::clamp(z, low, high);
}

void hang_on_wall(const Scene& scene, Luminaire& luminaire, double height) {
    const Room& room = *scene.room;
    const WallFoot wall = nearest_wall(room, Vec2(luminaire.position));
    const Vec3 inward(wall.inward, 0.0);
    const double facing = std::atan2(inward.y, inward.x);
    luminaire.tilt = luminaire.roll = 0.0;
    const Favour favour = favour_of(scene, luminaire);
    const Vec2 side(favour.direction);
    constexpr double one_sided = 0.05, mostly_down = 0.05;
    if (glm::length(side) > one_sided) {
        luminaire.yaw = facing - std::atan2(side.y, side.x);
    } else if (favour.upward < mostly_down) {
        luminaire.yaw = facing;
        luminaire.tilt = quarter;  // nadir towards plane C0, which faces the room
    } else {
        const Vec3 half = half_extent(scene, luminaire);
        luminaire.yaw = half.x > half.y ? facing - quarter : facing;  // its longer side along the wall
    }
    luminaire.yaw = std::remainder(luminaire.yaw, 4.0 * quarter);
    const double off = reach_along(scene, luminaire, inward) + flush;
    const double z = within_room(room, floor_of(room) + height, reach_upward(scene, luminaire));
    luminaire.position = Vec3(wall.foot + off * wall.inward, z);
}

}  // namespace

std::string_view name_of(Mounting mounting) {
    constexpr std::array<std::string_view, 5> names{"Recessed in the ceiling", "On the ceiling", "Pendant",
                                                    "On the wall", "Standing"};
    return names[static_cast<std::size_t>(mounting)];
}

Scene mounted(Scene scene, std::span<const ObjectId> luminaires, const MountingWish& wish) {
    if (!scene.room || scene.room->plan.size() < 3) return scene;
    const Room room = *scene.room;
    for (Luminaire& luminaire : scene.luminaires) {
        if (std::find(luminaires.begin(), luminaires.end(), luminaire.id) == luminaires.end()) continue;
        if (wish.mounting == Mounting::wall) {
            hang_on_wall(scene, luminaire, wish.height);
            continue;
        }
        luminaire.tilt = luminaire.roll = 0.0;
        const double reach = reach_upward(scene, luminaire);
        double z = floor_of(room) + wish.height;
        if (wish.mounting != Mounting::standing) {
            const double gap = wish.mounting == Mounting::recessed  ? flush
                               : wish.mounting == Mounting::surface ? housing
                                                                    : std::max(flush, wish.suspension);
            z = ceiling_of(room) - gap - reach;
        }
        luminaire.position.z = within_room(room, z, reach);
    }
    return scene;
}

MountingWish mounting_of(const Scene& scene, const Luminaire& luminaire) {
    MountingWish found;
    if (!scene.room || scene.room->plan.size() < 3) return found;
    const Room& room = *scene.room;
    const double gap = ceiling_of(room) - luminaire.position.z - reach_upward(scene, luminaire);
    found.height = luminaire.position.z - floor_of(room);
    found.suspension = std::max(0.0, gap);
    if (gap < 0.03)
        found.mounting = Mounting::recessed;
    else if (gap < shortest_suspension)
        found.mounting = Mounting::surface;
    else if (hangs_on_wall(scene, luminaire))
        found.mounting = Mounting::wall;
    else
        found.mounting = suspension_of(scene, luminaire) ? Mounting::pendant : Mounting::standing;
    return found;
}

}  // namespace hanei
