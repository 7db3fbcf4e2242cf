#include "engine/project/mesh_part.h"

#include "engine/geometry/polygon.h"
#include "engine/project/tidy.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace hanei {
namespace {

constexpr double thinnest = 1e-9;  // m: less is left of nothing once it is tidied
constexpr double rounding = 1e-6;  // of the box, and rad: what single precision leaves

double nearest_turn(double bearing) {
    const double turn = std::remainder(bearing, std::numbers::pi / 2.0);
    return std::abs(turn) < rounding ? 0.0 : turn;
}

/// The box that stands on this face.
std::optional<Part> box_on(const SolidShape& shape, const std::vector<int>& face) {
    const auto corner = [&](std::size_t k) { return shape.vertices[static_cast<std::size_t>(face[k])]; };
    const Vec3 a = corner(0), b = corner(1), c = corner(2), d = corner(3);
    if (!(unit_normal(Polygon{a, b, c, d}).z < -1.0 + rounding * rounding)) return std::nullopt;
    double top = a.z;
    for (const Vec3& vertex : shape.vertices) top = std::max(top, vertex.z);
    const double height = top - a.z;
    const double length = glm::distance(a, b), width = glm::distance(a, d);
    const double near = rounding * std::max({length, width, height});
    const auto is_below_a_corner = [&](const Vec3& foot) {
        return std::any_of(shape.vertices.begin(), shape.vertices.end(), [&](const Vec3& vertex) {
            return glm::distance(vertex, foot + Vec3{0.0, 0.0, height}) <= near;
        });
    };
    if (!(std::min({length, width, height}) > thinnest)) return std::nullopt;
    const bool upright = is_below_a_corner(a) && is_below_a_corner(b) && is_below_a_corner(c) && is_below_a_corner(d);
    const bool square =
        std::abs(glm::dot(b - a, d - a)) <= rounding * length * width && glm::distance(c, b + d - a) <= near;
    if (!upright || !square) return std::nullopt;
    const double bearing = std::atan2(b.y - a.y, b.x - a.x);
    Part box;
    box.rotation = tidy_angle(nearest_turn(bearing));
    const bool crosswise = std::abs(std::remainder(bearing - box.rotation, std::numbers::pi)) > 0.5;
    box.position = tidy_place(0.25 * (a + b + c + d));
    box.shape = BoxShape{tidy_place(crosswise ? Vec3{width, length, height} : Vec3{length, width, height})};
    return box;
}

}  // namespace

Part part_of(SolidShape shape, ObjectId material) {
    const bool may_be_a_box =
        shape.vertices.size() == 8 && shape.faces.size() == 6 &&
        std::all_of(shape.faces.begin(), shape.faces.end(), [](const auto& face) { return face.size() == 4; });
    Part part;
    for (const std::vector<int>& face : shape.faces) {
        if (!may_be_a_box) break;
        if (auto box = box_on(shape, face)) {
            box->material = material;
            return *box;
        }
    }
    part.shape = std::move(shape);
    part.material = material;
    return part;
}

}  // namespace hanei
