#include "engine/scene/faces.h"

#include "engine/geometry/polygon.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace hanei {
namespace {

/// Direction of the longest edge; the first of edges equally long to rounding, so that a square
/// keeps the direction it was drawn in.
Vec3 longest_edge(const Polygon& outline) {
    constexpr double clearly_longer = 1.0 + 1e-9;  // rounding of corners far from the origin
    Vec3 longest{0.0};
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vec3 edge = outline[(k + 1) % outline.size()] - outline[k];
        if (glm::length(edge) > clearly_longer * glm::length(longest)) longest = edge;
    }
    return glm::normalize(longest);
}

/// Appends the face unless it has no area (or no finite place).
Face* append(std::vector<Face>& faces, SurfaceRef ref, Region region, ObjectId material, LuminousExitance own = {}) {
    const Vec3 normal = unit_normal(region.outline);
    if (!(glm::length(normal) > 0.5)) return nullptr;
    const Vec3 along = longest_edge(region.outline);
    faces.push_back({ref, std::move(region), normal, along, material, own, {}});
    return &faces.back();
}

/// Room faces' own coordinates (SubArea) in the scene: place + x right + y up.
struct FaceFrame {
    Vec3 place{0.0};
    Vec3 right{1.0, 0.0, 0.0};
    Vec3 up{0.0, 1.0, 0.0};
    std::optional<Vec2> size;  ///< of a wall; floor and ceiling have the plan's outline
    bool mirrored = false;     ///< right x up points away from the lit side

    Vec3 point(double x, double y) const { return place + x * right + y * up; }
};

/// Sub-areas of one room face. Those of a wall end at its edges; those of floor and ceiling may
/// reach past the plan.
void append_areas(Face& face, const Room& room, const FaceFrame& frame) {
    for (const SubArea& area : room.sub_areas) {
        if (area.face != face.ref.face) continue;
        Vec2 low = area.low;
        Vec2 high = area.high;
        if (frame.size) {
            low = glm::max(low, Vec2{0.0});
            high = glm::min(high, *frame.size);
        }
        if (!(high.x > low.x && high.y > low.y)) continue;
        Polygon outline{frame.point(low.x, low.y), frame.point(high.x, low.y), frame.point(high.x, high.y),
                        frame.point(low.x, high.y)};
        if (frame.mirrored) std::swap(outline[1], outline[3]);
        face.areas.push_back({std::move(outline), area.material, area.id});
    }
}

void append_level(std::vector<Face>& faces, const Room& room, int number) {
    const bool floor = number == Room::floor_face;
    const double z = floor ? room.floor_height : room.floor_height + room.height;
    Region region;
    for (const Vec2& corner : room.plan) region.outline.emplace_back(corner, z);
    if (!floor) std::reverse(region.outline.begin(), region.outline.end());
    Face* face =
        append(faces, {room.id, number}, std::move(region), floor ? room.floor_material : room.ceiling_material);
    FaceFrame frame;
    frame.place.z = z;
    frame.mirrored = !floor;
    if (face != nullptr) append_areas(*face, room, frame);
}

void append_wall(std::vector<Face>& faces, const Room& room, std::size_t k) {
    const Vec3 from{room.plan[k], room.floor_height};
    const Vec3 to{room.plan[(k + 1) % room.plan.size()], room.floor_height};
    const Vec3 rise{0.0, 0.0, room.height};
    const ObjectId material = k < room.wall_materials.size() ? room.wall_materials[k] : ObjectId{};
    Face* face = append(faces, {room.id, Room::wall_face(static_cast<int>(k))},
                        {{to, from, from + rise, to + rise}, {}}, material);
    if (face == nullptr) return;
    const double length = glm::length(to - from);
    append_areas(*face, room, {from, (to - from) / length, {0.0, 0.0, 1.0}, Vec2{length, room.height}, true});
}

void append_room(std::vector<Face>& faces, const Room& room) {
    append_level(faces, room, Room::floor_face);
    append_level(faces, room, Room::ceiling_face);
    for (std::size_t k = 0; k < room.plan.size(); ++k) append_wall(faces, room, k);
}

/// Empty when the loop names a vertex that does not exist (a fault check_scene reports).
Polygon loop_of(const Shell& shell, const std::vector<int>& corners) {
    Polygon loop;
    for (const int corner : corners) {
        if (corner < 0 || static_cast<std::size_t>(corner) >= shell.vertices.size()) return {};
        loop.push_back(shell.vertices[static_cast<std::size_t>(corner)]);
    }
    return loop;
}

void append_furniture(std::vector<Face>& faces, const Scene& scene) {
    const std::vector<Shell> shells = shells_of(scene);
    std::size_t next = 0;
    for (const Furniture& furniture : scene.furniture) {
        for (const Part& part : furniture.parts) {
            const Shell& shell = shells[next++];
            int number = shell.first_face;
            for (const std::vector<int>& corners : shell.faces) {
                append(faces, {furniture.id, number++}, {loop_of(shell, corners), {}}, part.material);
            }
        }
    }
}

}  // namespace

std::vector<Face> faces_of(const Scene& scene) {
    std::vector<Face> faces;
    if (scene.room) append_room(faces, *scene.room);
    append_furniture(faces, scene);
    for (const FreeSurface& surface : scene.surfaces) {
        append(faces, {surface.id, 0}, surface.region, surface.material, surface.own_exitance);
    }
    return faces;
}

const Material* find_material(const Scene& scene, ObjectId id) {
    const auto found = std::find_if(scene.materials.begin(), scene.materials.end(),
                                    [id](const Material& material) { return material.id == id; });
    return found == scene.materials.end() ? nullptr : &*found;
}

}  // namespace hanei
