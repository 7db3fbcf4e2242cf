#include "engine/geometry/polygon.h"
#include "engine/mesh/contact.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hanei {

namespace {

/// The part of a convex polygon in the plane of a face, when it comes up to it from the front.
std::optional<Crease> meeting_line(const Polygon& sheet, const Plane& face, const Vec3& direction, double same_place) {
    std::vector<Vec3> on_plane;
    bool in_front = false;
    for (std::size_t k = 0; k < sheet.size(); ++k) {
        const Vec3& a = sheet[k];
        const Vec3& b = sheet[(k + 1) % sheet.size()];
        const double here = face.height(a);
        const double there = face.height(b);
        in_front = in_front || here > same_place;
        if (std::abs(here) <= same_place) {
            on_plane.push_back(a - here * face.normal);
        } else if (std::abs(there) > same_place && (here > 0.0) != (there > 0.0)) {
            on_plane.push_back(a + here / (here - there) * (b - a));
        }
    }
    if (!in_front || on_plane.size() < 2) return std::nullopt;
    const auto before = [&](const Vec3& a, const Vec3& b) { return glm::dot(a, direction) < glm::dot(b, direction); };
    const auto [first, last] = std::minmax_element(on_plane.begin(), on_plane.end(), before);
    if (glm::length(*last - *first) <= same_place) return std::nullopt;
    return Crease{*first, *last};
}

}  // namespace

std::vector<Crease> Contacts::creases_of(std::size_t face) const {
    const Plane plane{faces_[face].region.outline.front(), faces_[face].normal};
    std::vector<Crease> found;
    for (std::size_t g = 0; g < faces_.size(); ++g) {
        if (g == face || solid_of_[g] >= 0) continue;
        const Vec3 direction = glm::cross(plane.normal, faces_[g].normal);
        if (glm::length(direction) < 1e-6) continue;  // parallel: in one plane or apart
        for (const Polygon& piece : pieces_[g]) {
            if (const auto line = meeting_line(piece, plane, direction, same_place_)) found.push_back(*line);
        }
    }
    return found;
}

}  // namespace hanei
