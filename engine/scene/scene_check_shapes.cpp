#include "engine/base/tolerance.h"
#include "engine/geometry/polygon.h"
#include "engine/scene/scene_findings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace hanei {
namespace {

/// The polygon in coordinates of its own plane.
std::vector<Vec2> flattened(const Polygon& polygon, const Vec3& normal) {
    const Vec3 start = std::abs(normal.x) < 0.9 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
    const Vec3 right = glm::normalize(start - glm::dot(start, normal) * normal);
    const Vec3 up = glm::cross(normal, right);
    std::vector<Vec2> flat;
    for (const Vec3& point : polygon)
        flat.emplace_back(glm::dot(point - polygon[0], right), glm::dot(point - polygon[0], up));
    return flat;
}

bool check_loop(ObjectFindings& object, const std::string& field, const Polygon& loop) {
    if (!object.finite(field, loop)) return false;
    if (loop.size() < 3) {
        object.error(field, "found " + std::to_string(loop.size()) + " corners, at least 3 are needed");
        return false;
    }
    const Vec3 normal = unit_normal(loop);
    if (normal == Vec3{0.0}) {
        object.error(field, "it has no area; its corners lie on one line");
        return false;
    }
    const double off = distance_from_plane(loop);
    if (off > tolerance::planar * diameter(loop)) {
        object.error(field, "its corners leave their plane by " + figure(off) + " m; cut it into triangles");
        return false;
    }
    if (!is_simple(flattened(loop, normal))) {
        object.error(field, "its edges cross or touch each other, or a corner stands twice; draw a simple outline");
        return false;
    }
    return true;
}

using Edge = std::pair<int, int>;

bool has_sound_loops(ObjectFindings& object, const std::string& field, const std::vector<Vec3>& vertices,
                     const std::vector<std::vector<int>>& faces) {
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const std::string face = field + '[' + std::to_string(i) + ']';
        Polygon loop;
        for (const int vertex : faces[i]) {
            if (vertex < 0 || static_cast<std::size_t>(vertex) >= vertices.size()) {
                object.error(face, "found the vertex number " + std::to_string(vertex) + ", there are " +
                                       std::to_string(vertices.size()) + " vertices, counted from 0");
                return false;
            }
            loop.push_back(vertices[static_cast<std::size_t>(vertex)]);
        }
        if (!check_loop(object, face, loop)) return false;
    }
    return true;
}

/// Every edge belongs to exactly two faces, which run along it in opposite directions.
bool is_closed(const std::vector<std::vector<int>>& faces) {
    std::map<Edge, int> uses;
    for (const std::vector<int>& face : faces)
        for (std::size_t k = 0; k < face.size(); ++k) ++uses[{face[k], face[(k + 1) % face.size()]}];
    return faces.size() >= 4 && std::all_of(uses.begin(), uses.end(), [&](const auto& use) {
               const auto back = uses.find({use.first.second, use.first.first});
               return use.second == 1 && back != uses.end() && back->second == 1;
           });
}

Polygon loop_of(const std::vector<Vec3>& vertices, const std::vector<int>& face) {
    Polygon loop;
    for (const int vertex : face) loop.push_back(vertices[static_cast<std::size_t>(vertex)]);
    return loop;
}

double enclosed_volume(const std::vector<Vec3>& vertices, const std::vector<std::vector<int>>& faces) {
    double volume = 0.0;
    for (const std::vector<int>& face : faces) {
        const Polygon loop = loop_of(vertices, face);
        volume += glm::dot(loop[0] - vertices[0], vector_area(loop)) / 3.0;
    }
    return volume;
}

}  // namespace

void check_region(ObjectFindings& object, const std::string& field, const Region& region) {
    const std::string prefix = field.empty() ? "" : field + '.';
    if (!check_loop(object, prefix + "outline", region.outline)) return;
    const Plane plane{region.outline[0], unit_normal(region.outline)};
    const double thickness = tolerance::planar * diameter(region.outline);
    for (std::size_t i = 0; i < region.holes.size(); ++i) {
        const std::string hole = prefix + "holes[" + std::to_string(i) + ']';
        if (!check_loop(object, hole, region.holes[i])) continue;
        const bool in_plane = std::all_of(region.holes[i].begin(), region.holes[i].end(), [&](const Vec3& point) {
            return std::abs(plane.height(point)) <= thickness;
        });
        if (!in_plane)
            object.error(hole, "the hole does not lie in the plane of the outline");
        else if (glm::dot(unit_normal(region.holes[i]), plane.normal) > 0.0)
            object.error(hole, "the hole runs the same way as the outline; list its corners the other way round");
    }
    if (!(glm::dot(vector_area(region), plane.normal) > 0.0))
        object.error(prefix + "holes", "the holes leave no area of the outline");
}

void check_solid(ObjectFindings& object, const std::string& field, const std::vector<Vec3>& vertices,
                 const std::vector<std::vector<int>>& faces) {
    if (!object.finite(field, vertices) || !has_sound_loops(object, field, vertices, faces)) return;
    if (!is_closed(faces))
        object.error(field,
                     "the solid is not closed: every edge must belong to exactly two faces that run along it "
                     "in opposite directions");
    else if (enclosed_volume(vertices, faces) < 0.0)
        object.error(field,
                     "the solid is inside out: list the corners of each face counter-clockwise seen from outside");
}

}  // namespace hanei
