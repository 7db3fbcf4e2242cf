#include "ui/view/left_out.h"

#include "engine/scene/faces.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

constexpr double under_the_ceiling = 1e-3;  // m

/// Any two directions in the plane.
std::pair<Vec3, Vec3> directions_in(const Cut& plane) {
    const Vec3 aside = std::abs(plane.normal.z) < 0.9 ? Vec3(0.0, 0.0, 1.0) : Vec3(1.0, 0.0, 0.0);
    const Vec3 along = glm::normalize(glm::cross(aside, plane.normal));
    return {along, glm::cross(plane.normal, along)};
}

double above(const Cut& plane, const Vec3& place) { return glm::dot(plane.normal, place) - plane.offset; }

/// Where a line passes through the plane; empty when both ends are on one side.
std::optional<Vec3> crossing(const Cut& plane, const Vec3& from, const Vec3& to) {
    const double a = above(plane, from), b = above(plane, to);
    if ((a > 0.0) == (b > 0.0)) return std::nullopt;
    return glm::mix(from, to, a / (a - b));
}

/// The places in the order of their angle about the middle: the corners of a convex polygon.
Polygon around(const std::vector<Vec3>& places, const Cut& plane) {
    const auto [along, across] = directions_in(plane);
    Vec3 middle(0.0);
    for (const Vec3& place : places) middle += place / static_cast<double>(places.size());
    std::vector<std::pair<double, Vec3>> turned;
    for (const Vec3& place : places)
        turned.emplace_back(std::atan2(glm::dot(place - middle, across), glm::dot(place - middle, along)), place);
    std::sort(turned.begin(), turned.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    Polygon polygon;
    for (const auto& [angle, place] : turned) polygon.push_back(place);
    return polygon;
}

bool inside(const Polygon& convex, const Vec3& normal, const Vec3& place) {
    for (std::size_t k = 0; k < convex.size(); ++k) {
        const Vec3 side = convex[(k + 1) % convex.size()] - convex[k];
        if (glm::dot(glm::cross(side, place - convex[k]), normal) < 0.0) return false;
    }
    return true;
}

}  // namespace

CutPlanes::CutPlanes(const LeftOut& left_out, const Scene* scene) : cut(left_out.cut) {
    if (left_out.ceiling && scene != nullptr && scene->room)
        ceiling = Cut{{0.0, 0.0, 1.0}, scene->room->floor_height + scene->room->height - under_the_ceiling};
}

std::vector<Polygon> sections_of(const Scene& scene, const Cut& plane) {
    std::vector<Polygon> sections;
    for (const Solid& solid : solids_of(scene)) {
        std::vector<Vec3> places;
        for (const std::vector<int>& face : solid.faces) {
            for (std::size_t k = 0; k < face.size(); ++k) {
                const std::size_t from = static_cast<std::size_t>(face[k]);
                const std::size_t to = static_cast<std::size_t>(face[(k + 1) % face.size()]);
                if (from > to) continue;  // each edge lies between two faces
                if (const auto place = crossing(plane, solid.vertices[from], solid.vertices[to]))
                    places.push_back(*place);
            }
        }
        if (places.size() >= 3) sections.push_back(around(places, plane));
    }
    return sections;
}

std::vector<std::pair<Vec3, Vec3>> cut_lines_of(const Scene& scene, const Cut& plane) {
    std::vector<std::pair<Vec3, Vec3>> lines;
    for (const Face& face : faces_of(scene)) {
        const bool of_furniture = std::any_of(scene.furniture.begin(), scene.furniture.end(),
                                              [&](const Furniture& each) { return each.id == face.ref.object; });
        if (of_furniture) continue;  // shown by its sections
        for (const Polygon& piece : convex_pieces(face.region)) {
            std::vector<Vec3> ends;
            for (std::size_t k = 0; k < piece.size(); ++k) {
                if (const auto place = crossing(plane, piece[k], piece[(k + 1) % piece.size()])) ends.push_back(*place);
            }
            if (ends.size() == 2) lines.emplace_back(ends[0], ends[1]);
        }
    }
    return lines;
}

bool meets_section(const Scene& scene, const CutPlanes& planes, const Ray& ray, double before) {
    for (const std::optional<Cut>& plane : {planes.cut, planes.ceiling}) {
        if (!plane) continue;
        const double distance = -above(*plane, ray.origin) / glm::dot(plane->normal, ray.direction);
        if (!std::isfinite(distance) || distance < 0.0 || distance > before) continue;
        const Vec3 place = ray.origin + distance * ray.direction;
        for (const Polygon& section : sections_of(scene, *plane)) {
            if (inside(section, plane->normal, place)) return true;
        }
    }
    return false;
}

}  // namespace hanei
