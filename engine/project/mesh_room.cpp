#include "engine/project/mesh_room.h"

#include "engine/geometry/flat_faces.h"
#include "engine/geometry/polygon.h"
#include "engine/project/tidy.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace hanei {
namespace {

/// Faces by where they look; walls by the edge they stand on, outward: the plan runs the other way.
struct Sides {
    std::vector<const FlatFace*> floors, ceilings;
    std::vector<const FlatFace*> walls;
};

std::optional<Sides> sides_of(const TriangleShell& shell, const std::vector<FlatFace>& faces) {
    constexpr double level = 1e-6;  // rad
    Sides sides;
    for (const FlatFace& face : faces) {
        const double up = unit_normal(polygon_of(shell.vertices, face.loop)).z;
        if (up > 1.0 - level)
            sides.ceilings.push_back(&face);
        else if (up < -1.0 + level)
            sides.floors.push_back(&face);
        else if (std::abs(up) < level && face.loop.size() == 4)
            sides.walls.push_back(&face);
        else
            return std::nullopt;
    }
    if (sides.floors.size() != 1 || sides.ceilings.size() != 1) return std::nullopt;
    return sides;
}

bool looks_inward(const TriangleShell& shell) { return shell.turned == shell.triangles.size(); }

bool is_as_large_as_a_room(const TriangleShell& shell) {
    constexpr double height = 1.8, width = 1.5;  // m
    Vec3 low = shell.vertices[0], high = low;
    for (const Vec3& vertex : shell.vertices) {
        low = glm::min(low, vertex);
        high = glm::max(high, vertex);
    }
    const Vec3 size = high - low;
    return size.z >= height && size.x >= width && size.y >= width;
}

Vec3 middle_of(const TriangleShell& shell) {
    Vec3 sum{0.0};
    for (const Vec3& vertex : shell.vertices) sum += vertex;
    return sum / static_cast<double>(shell.vertices.size());
}

bool holds_the_rest(const TriangleShell& room, const std::vector<const TriangleShell*>& shells,
                    const std::vector<Vec3>& places) {
    constexpr std::size_t most = 2000;  // a file of that many pieces is no room with furniture
    constexpr double inward = 0.01;     // off floor, walls and ceiling, for what stands against them
    std::vector<Vec3> rest = places;
    for (const TriangleShell* const shell : shells)
        if (shell != &room) rest.push_back(middle_of(*shell));
    const Vec3 middle = middle_of(room);
    return !rest.empty() && rest.size() <= most && std::all_of(rest.begin(), rest.end(), [&](const Vec3& place) {
        return winding_number(room, glm::mix(place, middle, inward)) > 0.5;
    });
}

}  // namespace

std::optional<Room> room_of(const TriangleShell& shell, const MeshObject& object,
                            const std::vector<GltfMaterial>& materials) {
    const std::vector<FlatFace> faces = flat_faces(shell, {false, false, object.distance});
    const auto sides = sides_of(shell, faces);
    if (!sides) return std::nullopt;
    const auto material = [&](const FlatFace& face) {
        return materials[static_cast<std::size_t>(face.label)].material.id;
    };
    const auto at = [&](int vertex) { return shell.vertices[static_cast<std::size_t>(vertex)]; };
    std::vector<int> floor = sides->floors[0]->loop;
    std::reverse(floor.begin(), floor.end());
    if (sides->walls.size() != floor.size() || sides->ceilings[0]->loop.size() != floor.size()) return std::nullopt;
    std::map<std::pair<int, int>, const FlatFace*> wall_on;  // by the floor's edge as the wall runs it
    for (const FlatFace* const wall : sides->walls)
        for (std::size_t k = 0; k < 4; ++k) wall_on[{wall->loop[k], wall->loop[(k + 1) % 4]}] = wall;
    Room room;
    room.name = object.name;
    room.floor_height = tidy_length(at(floor[0]).z);
    room.height = tidy_length(at(sides->ceilings[0]->loop[0]).z - room.floor_height);
    room.floor_material = material(*sides->floors[0]);
    room.ceiling_material = material(*sides->ceilings[0]);
    for (std::size_t k = 0; k < floor.size(); ++k) {
        const int from = floor[k], to = floor[(k + 1) % floor.size()];
        const auto wall = wall_on.find({from, to});
        if (wall == wall_on.end()) return std::nullopt;
        room.plan.emplace_back(tidy_length(at(from).x), tidy_length(at(from).y));
        room.wall_materials.push_back(material(*wall->second));
    }
    return room;
}

std::optional<std::size_t> room_among(const std::vector<const TriangleShell*>& shells, const std::vector<Vec3>& places,
                                      bool asked) {
    std::optional<std::size_t> best;
    std::pair<bool, double> rank;
    for (std::size_t k = 0; k < shells.size(); ++k) {
        const TriangleShell& shell = *shells[k];
        const std::pair<bool, double> its{looks_inward(shell), shell.volume};
        if (!shell.closed || (best && its <= rank)) continue;
        const bool fits =
            asked || (is_as_large_as_a_room(shell) && (looks_inward(shell) || holds_the_rest(shell, shells, places)));
        if (!fits) continue;
        best = k;
        rank = its;
    }
    return best;
}

}  // namespace hanei
