#include "engine/edit/sub_areas.h"

#include "engine/edit/material_palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

constexpr double narrowest = 0.05;  // m
constexpr double beside = 0.1;      // m, between a copy and its original

constexpr std::array kinds{
    SubAreaKind{"door", "Door", "Single door, 0.9 m x 2.1 m", "Door", {0.9, 2.1}, 0.0},
    SubAreaKind{"double-door", "Double door", "Door with two leaves, 1.8 m x 2.1 m", "Door", {1.8, 2.1}, 0.0},
    SubAreaKind{
        "window", "Window", "Window pane, 1.5 m x 1.4 m, dark as by night", "Window pane by night", {1.5, 1.4}, 0.9},
    SubAreaKind{"window-band", "Window band", "Band of windows, 4 m x 1.5 m", "Window pane by night", {4.0, 1.5}, 0.9},
    SubAreaKind{"whiteboard", "Whiteboard", "2.4 m x 1.2 m", "Whiteboard", {2.4, 1.2}, 0.9},
    SubAreaKind{"chalkboard", "Chalkboard", "4 m x 1.2 m", "Chalkboard", {4.0, 1.2}, 0.9},
    SubAreaKind{"pinboard", "Pinboard", "1.2 m x 0.9 m", "Pinboard", {1.2, 0.9}, 1.0},
    SubAreaKind{
        "picture", "Picture", "0.8 m x 0.6 m, its middle at the height of the eyes", "Picture", {0.8, 0.6}, 1.25},
    SubAreaKind{"curtain", "Curtain", "2 m x 2.2 m", "Curtain", {2.0, 2.2}, 0.05},
    SubAreaKind{"carpet", "Carpet", "3 m x 2 m, on the floor", "Carpet, dark", {3.0, 2.0}, 0.0, true},
};

double neat(double length) { return std::round(length * 1e9) / 1e9; }

SubArea* sub_area(Scene& scene, ObjectId id) {
    if (!scene.room) return nullptr;
    for (SubArea& area : scene.room->sub_areas)
        if (area.id == id) return &area;
    return nullptr;
}

bool overlaps(const SubArea& a, const SubArea& b) {
    return a.face == b.face && a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

bool is_free(const Room& room, const SubArea& area) {
    return std::none_of(room.sub_areas.begin(), room.sub_areas.end(),
                        [&](const SubArea& other) { return other.id != area.id && overlaps(area, other); });
}

void put_at(SubArea& area, double middle) {
    const double half = 0.5 * (area.high.x - area.low.x);
    area.low.x = neat(middle - half);
    area.high.x = neat(middle + half);
}

/// As near to `middle` as it covers no other, on a raster of 0.1 m; at `middle` when the face is full.
void put_free(SubArea& area, const Room& room, const RoomFace& face, double middle) {
    constexpr double raster = 0.1;
    for (int k = 0; k * raster <= face.size().x; ++k)
        for (const double side : {1.0, -1.0}) {
            SubArea tried = area;
            put_at(tried, middle + side * k * raster);
            if (tried.low.x < face.low.x || tried.high.x > face.high.x || !is_free(room, tried)) continue;
            area = tried;
            return;
        }
    put_at(area, middle);
}

std::string numbered_name(const Room& room, std::string_view label) {
    for (int k = 1;; ++k) {
        const std::string name = k == 1 ? std::string(label) : fmt::format("{} {}", label, k);
        const auto taken = [&](const SubArea& area) { return area.name == name; };
        if (std::none_of(room.sub_areas.begin(), room.sub_areas.end(), taken)) return name;
    }
}

std::optional<SubArea> made(Scene& scene, const SubAreaKind& kind, int face) {
    const std::optional<RoomFace> frame = scene.room ? room_face(*scene.room, face) : std::nullopt;
    if (!frame) return std::nullopt;
    SubArea area;
    area.name = numbered_name(*scene.room, kind.label);
    area.face = face;
    const double low = face < Room::wall_face(0) ? 0.5 * (frame->low.y + frame->high.y - kind.size.y) : kind.sill;
    area.low = {0.0, neat(low)};
    area.high = {kind.size.x, neat(low + kind.size.y)};
    put_at(area, 0.5 * (frame->low.x + frame->high.x));
    if (!fit_into_face(area, *scene.room)) return std::nullopt;
    area.material = material_named(scene, kind.material);
    area.id = scene.new_id();
    return area;
}

ObjectId add_to(Room& room, SubArea area) {
    room.sub_areas.push_back(std::move(area));
    return room.sub_areas.back().id;
}

}  // namespace

std::span<const SubAreaKind> sub_area_kinds() { return kinds; }

const SubAreaKind* find_sub_area_kind(std::string_view kind) {
    const auto found =
        std::find_if(kinds.begin(), kinds.end(), [&](const SubAreaKind& one) { return one.kind == kind; });
    return found == kinds.end() ? nullptr : &*found;
}

const SubArea* find_sub_area(const Scene& scene, ObjectId id) {
    if (!scene.room) return nullptr;
    for (const SubArea& area : scene.room->sub_areas)
        if (area.id == id) return &area;
    return nullptr;
}

bool fit_into_face(SubArea& area, const Room& room) {
    const std::optional<RoomFace> face = room_face(room, area.face);
    if (!face) return false;
    for (int k = 0; k < 2; ++k) {
        const double length = area.high[k] - area.low[k];
        const double fitted = std::min(length, face->size()[k]);
        if (!(fitted >= narrowest)) return false;
        const double low = std::clamp(area.low[k], face->low[k], face->high[k] - fitted);
        if (low == area.low[k] && fitted == length) continue;  // not even a rounding is changed
        area.low[k] = low;
        area.high[k] = std::min(low + fitted, face->high[k]);
    }
    return true;
}

Added with_sub_area(Scene scene, const SubAreaKind& kind, int face) {
    std::optional<SubArea> area = made(scene, kind, face);
    if (!area) return {std::move(scene), {}};
    put_free(*area, *scene.room, *room_face(*scene.room, face), 0.5 * (area->low.x + area->high.x));
    const ObjectId id = add_to(*scene.room, std::move(*area));
    return {std::move(scene), id};
}

Added with_sub_area(Scene scene, const SubAreaKind& kind, int face, double middle) {
    std::optional<SubArea> area = made(scene, kind, face);
    if (!area) return {std::move(scene), {}};
    put_at(*area, middle);
    fit_into_face(*area, *scene.room);
    const ObjectId id = add_to(*scene.room, std::move(*area));
    return {std::move(scene), id};
}

std::optional<Vec3> place_of_sub_area(const Scene& scene, ObjectId id) {
    const SubArea* const area = find_sub_area(scene, id);
    const std::optional<RoomFace> face = area == nullptr ? std::nullopt : room_face(*scene.room, area->face);
    if (!face) return std::nullopt;
    return face->point(0.5 * (area->low + area->high));
}

Scene with_sub_area_moved(Scene scene, ObjectId id, const Vec3& by) {
    SubArea* const area = sub_area(scene, id);
    const std::optional<RoomFace> face = area == nullptr ? std::nullopt : room_face(*scene.room, area->face);
    if (!face) return scene;
    const Vec2 slide{glm::dot(by, face->right), glm::dot(by, face->up)};
    SubArea moved = *area;
    for (int k = 0; k < 2; ++k) {
        if (std::abs(slide[k]) < 1e-9) continue;
        const double length = moved.high[k] - moved.low[k];
        moved.low[k] = neat(moved.low[k] + slide[k]);
        moved.high[k] = moved.low[k] + length;
    }
    if (fit_into_face(moved, *scene.room)) *area = std::move(moved);
    return scene;
}

Added with_sub_area_pasted(Scene scene, SubArea area, const Vec3& by, const std::optional<FacePlace>& at) {
    if (!scene.room) return {std::move(scene), {}};
    const auto is_level = [](int face) { return face < Room::wall_face(0); };
    const bool goes_there = at && is_level(at->face) == is_level(area.face);
    if (goes_there) area.face = at->face;
    if (area.face >= face_count(*scene.room)) area.face = Room::wall_face(0);
    const RoomFace face = *room_face(*scene.room, area.face);
    Vec2 middle = 0.5 * (area.low + area.high) + Vec2{glm::dot(by, face.right), glm::dot(by, face.up)};
    if (goes_there) middle = {at->at.x, is_level(area.face) ? at->at.y : middle.y};
    const double half = 0.5 * (area.high.y - area.low.y);
    area.low.y = neat(middle.y - half);
    area.high.y = neat(middle.y + half);
    area.id = {};
    put_free(area, *scene.room, face, middle.x);
    if (!fit_into_face(area, *scene.room)) return {std::move(scene), {}};
    const std::string label = area.name.substr(0, area.name.find_last_not_of("0123456789 ") + 1);
    area.name = numbered_name(*scene.room, label.empty() ? "Area" : label);
    area.id = scene.new_id();
    const ObjectId added = add_to(*scene.room, std::move(area));
    return {std::move(scene), added};
}

Added with_sub_area_copied(Scene scene, ObjectId id) {
    const SubArea* const area = find_sub_area(scene, id);
    const std::optional<RoomFace> face = area == nullptr ? std::nullopt : room_face(*scene.room, area->face);
    if (!face) return {std::move(scene), {}};
    SubArea copy = *area;
    copy.id = scene.new_id();
    std::string label = copy.name.substr(0, copy.name.find_last_not_of("0123456789 ") + 1);
    copy.name = numbered_name(*scene.room, label.empty() ? "Area" : label);
    put_free(copy, *scene.room, *face, 0.5 * (copy.low.x + copy.high.x) + (copy.high.x - copy.low.x) + beside);
    fit_into_face(copy, *scene.room);
    const ObjectId added = add_to(*scene.room, std::move(copy));
    return {std::move(scene), added};
}

}  // namespace hanei
