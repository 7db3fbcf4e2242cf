#include "engine/project/windings.h"

#include "engine/geometry/polygon.h"

#include <algorithm>

namespace hanei {
namespace {

/// Wall k, from corner k to the next, becomes wall n - 1 - k and runs the other way.
void reverse_plan(Room& room) {
    const int walls = static_cast<int>(room.plan.size());
    for (SubArea& area : room.sub_areas) {
        const int k = area.face - Room::wall_face(0);
        if (k < 0 || k >= walls) continue;
        const auto corner = static_cast<std::size_t>(k);
        const double length = glm::distance(room.plan[corner], room.plan[(corner + 1) % room.plan.size()]);
        area.face = Room::wall_face(walls - 1 - k);
        area.low.x = length - area.low.x;
        area.high.x = length - area.high.x;
        std::swap(area.low.x, area.high.x);
    }
    std::reverse(room.plan.begin() + 1, room.plan.end());
    std::reverse(room.wall_materials.begin(), room.wall_materials.end());
}

bool has_sound_faces(const std::vector<Vec3>& vertices, const std::vector<std::vector<int>>& faces) {
    const int count = static_cast<int>(vertices.size());
    return std::all_of(faces.begin(), faces.end(), [&](const std::vector<int>& face) {
        return std::all_of(face.begin(), face.end(), [&](int vertex) { return vertex >= 0 && vertex < count; });
    });
}

/// Six times the volume enclosed by faces that run counter-clockwise seen from outside.
double enclosed(const std::vector<Vec3>& vertices, const std::vector<std::vector<int>>& faces) {
    const auto at = [&](int vertex) { return vertices[static_cast<std::size_t>(vertex)] - vertices[0]; };
    double sum = 0.0;
    for (const std::vector<int>& face : faces)
        for (std::size_t k = 2; k < face.size(); ++k)
            sum += glm::dot(at(face[0]), glm::cross(at(face[k - 1]), at(face[k])));
    return sum;
}

bool turned_right(const std::vector<Vec3>& vertices, std::vector<std::vector<int>>& faces) {
    if (!has_sound_faces(vertices, faces) || enclosed(vertices, faces) >= 0.0) return false;
    for (std::vector<int>& face : faces) std::reverse(face.begin(), face.end());
    return true;
}

constexpr const char* inside_out = "the solid was inside out: its faces ran clockwise seen from outside; turned round";

}  // namespace

std::vector<RepairedWinding> repair_windings(Scene& scene) {
    std::vector<RepairedWinding> repairs;
    if (scene.room.has_value() && signed_area(scene.room->plan) < 0.0) {
        reverse_plan(*scene.room);
        repairs.push_back({"room.plan", scene.room->id,
                           "the plan ran clockwise; it was turned round together with its walls and their sub-areas"});
    }
    for (std::size_t i = 0; i < scene.furniture.size(); ++i) {
        for (std::size_t k = 0; k < scene.furniture[i].parts.size(); ++k) {
            auto* const solid = std::get_if<SolidShape>(&scene.furniture[i].parts[k].shape);
            if (solid != nullptr && turned_right(solid->vertices, solid->faces))
                repairs.push_back({"furniture[" + std::to_string(i) + "].parts[" + std::to_string(k) + "].faces",
                                   scene.furniture[i].id, inside_out});
        }
    }
    for (std::size_t i = 0; i < scene.luminaires.size(); ++i) {
        auto* const solid = std::get_if<PolyhedronOpening>(&scene.luminaires[i].opening);
        if (solid != nullptr && turned_right(solid->vertices, solid->faces))
            repairs.push_back(
                {"luminaires[" + std::to_string(i) + "].opening.faces", scene.luminaires[i].id, inside_out});
    }
    return repairs;
}

}  // namespace hanei
