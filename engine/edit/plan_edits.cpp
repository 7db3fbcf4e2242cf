#include "engine/edit/plan_edits.h"

#include "engine/edit/plan_shape.h"
#include "engine/edit/sub_areas.h"
#include "engine/geometry/polygon.h"
#include "engine/scene/faces.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

constexpr double steep = 0.34;  // sine of 20 degrees

double neat(double length) { return std::round(length * 1e9) / 1e9; }
Vec2 neat(const Vec2& place) { return {neat(place.x), neat(place.y)}; }
double across(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

/// A plan on its way: which old wall each new one was.
struct Outline {
    std::vector<Vec2> plan;
    std::vector<int> was;  ///< old wall of each wall; -1: a new one
};

Outline outline_of(const Room& room) {
    Outline outline{room.plan, {}};
    for (std::size_t k = 0; k < room.plan.size(); ++k) outline.was.push_back(static_cast<int>(k));
    return outline;
}

std::string listed(const std::vector<std::string>& names) {
    if (names.empty()) return {};
    if (names.size() == 1) return names[0] + " went with its wall";
    return fmt::format("{} and {} more went with their walls", names[0], names.size() - 1);
}

/// Where the middle of a wall's sub-area was, in the scene.
Vec3 middle_of(const Room& room, const SubArea& area) {
    return room_face(room, area.face)->point(0.5 * (area.low + area.high));
}

/// Follows to the wall's new place and length.
bool follow(SubArea& area, const Room& before, const Room& after, int wall) {
    const Vec3 middle = middle_of(before, area);
    area.face = Room::wall_face(wall);
    const std::optional<RoomFace> face = room_face(after, area.face);
    if (!face) return false;
    const double half = 0.5 * (area.high.x - area.low.x), now = 0.5 * (area.low.x + area.high.x);
    const double at = neat(face->within(middle).x);
    if (std::abs(at - now) > 1e-9) {
        area.low.x = neat(at - half);
        area.high.x = neat(at + half);
    }
    return fit_into_face(area, after);
}

PlanEdit edited(const Scene& scene, Outline outline) {
    if (std::string fault = fault_of_plan(outline.plan); !fault.empty()) return {std::nullopt, std::move(fault)};
    if (!is_simple(outline.plan)) return {std::nullopt, "Two corners would stand on one place; keep them apart."};
    if (signed_area(outline.plan) < 0.0)
        return {std::nullopt, "The wall would pass the one opposite; leave some room between them."};
    Scene wished = scene;
    Room& room = *wished.room;
    const Room& before = *scene.room;
    room.plan = outline.plan;
    room.wall_materials.clear();
    for (const int was : outline.was)
        room.wall_materials.push_back(before.wall_materials[static_cast<std::size_t>(std::max(0, was))]);
    room.sub_areas.clear();
    std::vector<std::string> gone;
    for (const SubArea& area : before.sub_areas) {
        SubArea kept = area;
        bool stays = false;
        if (area.face < Room::wall_face(0)) {
            stays = fit_into_face(kept, room);
        } else {
            const int wall = area.face - Room::wall_face(0);
            const double middle = 0.5 * (area.low.x + area.high.x);
            // Of a wall that was cut in two, the part that the middle lies on.
            for (std::size_t k = 0; k < outline.was.size() && !stays; ++k) {
                if (outline.was[k] != wall) continue;
                SubArea tried = area;
                const bool fits = follow(tried, before, room, static_cast<int>(k));
                const bool last = std::find(outline.was.begin() + static_cast<std::ptrdiff_t>(k) + 1, outline.was.end(),
                                            wall) == outline.was.end();
                const double length = wall_length(room, k);
                const Vec2 from = room.plan[k];
                const Vec3 was_at = room_face(before, area.face)->point({middle, 0.0});
                const double at = glm::dot(Vec2(was_at) - from, room.plan[(k + 1) % room.plan.size()] - from) / length;
                stays = fits && (last || at <= length);
                if (stays) kept = tried;
            }
        }
        if (stays)
            room.sub_areas.push_back(std::move(kept));
        else
            gone.push_back(display_name(scene, area.id));
    }
    return {std::move(wished), listed(gone)};
}

/// Where the line through a corner in its wall's direction meets the shifted wall.
Vec2 on_shifted(const Vec2& corner, const Vec2& neighbour, const Vec2& from, const Vec2& along, const Vec2& shift) {
    const Vec2 direction = corner - neighbour;
    const double length = glm::length(direction);
    const double sine = length > 0.0 ? across(direction / length, along) : 0.0;
    if (std::abs(sine) < steep) return corner + shift;  // nearly along the wall: the meeting point runs far away
    const double t = across(from + shift - neighbour, along) / across(direction, along);
    return neighbour + t * direction;
}

const char* const no_room = "There is no room yet: draw a plan or make a new room first.";
const char* const no_wall = "The room has no such wall.";

}  // namespace

PlanEdit with_corner_moved(const Scene& scene, std::size_t corner, const Vec2& to) {
    if (!scene.room) return {std::nullopt, no_room};
    if (corner >= scene.room->plan.size()) return {std::nullopt, no_wall};
    Outline outline = outline_of(*scene.room);
    outline.plan[corner] = neat(to);
    return edited(scene, std::move(outline));
}

PlanEdit with_wall_moved(const Scene& scene, std::size_t wall, double by) {
    if (!scene.room) return {std::nullopt, no_room};
    const std::vector<Vec2>& plan = scene.room->plan;
    const std::size_t count = plan.size();
    if (wall >= count) return {std::nullopt, no_wall};
    const std::size_t next = (wall + 1) % count;
    const Vec2 along = glm::normalize(plan[next] - plan[wall]);
    const Vec2 shift = by * Vec2{along.y, -along.x};  // outward of a plan that runs counter-clockwise
    Outline outline = outline_of(*scene.room);
    outline.plan[wall] = neat(on_shifted(plan[wall], plan[(wall + count - 1) % count], plan[wall], along, shift));
    outline.plan[next] = neat(on_shifted(plan[next], plan[(next + 1) % count], plan[wall], along, shift));
    return edited(scene, std::move(outline));
}

PlanEdit with_corner_inserted(const Scene& scene, std::size_t wall, const Vec2& at) {
    if (!scene.room) return {std::nullopt, no_room};
    if (wall >= scene.room->plan.size()) return {std::nullopt, no_wall};
    Outline outline = outline_of(*scene.room);
    const auto place = static_cast<std::ptrdiff_t>(wall) + 1;
    outline.plan.insert(outline.plan.begin() + place, neat(at));
    outline.was.insert(outline.was.begin() + place, static_cast<int>(wall));
    return edited(scene, std::move(outline));
}

PlanEdit with_corner_removed(const Scene& scene, std::size_t corner) {
    if (!scene.room) return {std::nullopt, no_room};
    if (corner >= scene.room->plan.size()) return {std::nullopt, no_wall};
    if (scene.room->plan.size() == 3) return {std::nullopt, "A plan needs three corners that are not on one line."};
    Outline outline = outline_of(*scene.room);
    outline.plan.erase(outline.plan.begin() + static_cast<std::ptrdiff_t>(corner));
    outline.was.erase(outline.was.begin() + static_cast<std::ptrdiff_t>(corner));
    return edited(scene, std::move(outline));
}

PlanEdit with_wall_length(const Scene& scene, std::size_t wall, double length) {
    if (!scene.room) return {std::nullopt, no_room};
    const std::vector<Vec2>& plan = scene.room->plan;
    if (wall >= plan.size()) return {std::nullopt, no_wall};
    if (!(length > 0.0)) return {std::nullopt, "A wall must be longer than 0 m."};
    const std::size_t end = (wall + 1) % plan.size(), after = (wall + 2) % plan.size();
    const Vec2 along = glm::normalize(plan[end] - plan[wall]);
    const Vec2 shift = (length - glm::distance(plan[end], plan[wall])) * along;
    Outline outline = outline_of(*scene.room);
    outline.plan[end] = neat(plan[end] + shift);
    // The wall after it moves along where that keeps a right angle at its far end.
    const Vec2 beyond = plan[(after + 1) % plan.size()] - plan[after];
    const bool parallel = std::abs(across(glm::normalize(beyond), along)) < 1e-6;
    if (parallel && plan.size() > 3) outline.plan[after] = neat(plan[after] + shift);
    return edited(scene, std::move(outline));
}

PlanEdit with_plan(const Scene& scene, const std::vector<Vec2>& plan) {
    if (std::string fault = fault_of_plan(plan); !fault.empty()) return {std::nullopt, std::move(fault)};
    if (scene.room) {
        Outline outline{tidy_plan(plan), {}};
        outline.was.assign(outline.plan.size(), -1);
        return edited(scene, std::move(outline));
    }
    Scene wished = scene;
    const Scene usual = empty_room();
    wished.room = usual.room;
    wished.room->id = wished.new_id();
    wished.room->plan = tidy_plan(plan);
    const auto taken_over = [&](ObjectId material) {
        Material copy = *find_material(usual, material);
        copy.id = wished.new_id();
        wished.materials.push_back(std::move(copy));
        return wished.materials.back().id;
    };
    wished.room->ceiling_material = taken_over(usual.room->ceiling_material);
    wished.room->wall_materials.assign(plan.size(), taken_over(usual.room->wall_materials.front()));
    wished.room->wall_materials.resize(wished.room->plan.size());
    wished.room->floor_material = taken_over(usual.room->floor_material);
    return {std::move(wished), {}};
}

Scene new_room(const NewRoom& wished) {
    Scene scene = empty_room();
    scene.room->plan = usual_plan(wished.shape, wished.length, wished.width);
    scene.room->wall_materials.resize(scene.room->plan.size(), scene.room->wall_materials.front());
    scene.room->height = wished.height;
    scene.room->floor_height = wished.floor_height;
    return with_reflectances(std::move(scene), wished.reflectances);
}

}  // namespace hanei
