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

/// Sheets nearer to a face than this share of their own size shade it as if they lay on it.
constexpr double closely_over = 0.05;

bool lies_closely_over(const Polygon& sheet, const Plane& face, double same_place) {
    return std::all_of(sheet.begin(), sheet.end(), [&](const Vec3& corner) {
        const double height = face.height(corner);
        return height > same_place && height <= closely_over * diameter(sheet);
    });
}

/// The long edges of a sheet projected on a face; those of a circle's outline are none.
void add_edges_below(const Polygon& sheet, const Plane& face, std::vector<Crease>& found) {
    const double shortest = 0.25 * diameter(sheet);
    for (std::size_t k = 0; k < sheet.size(); ++k) {
        const Vec3& a = sheet[k];
        const Vec3& b = sheet[(k + 1) % sheet.size()];
        if (glm::length(b - a) < shortest) continue;
        found.push_back({a - face.height(a) * face.normal, b - face.height(b) * face.normal});
    }
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
    for (const ConvexBody& opening : openings_) {
        const bool flat = opening.faces.size() == 1;
        if (flat && lies_closely_over(opening.vertices, plane, same_place_)) {
            add_edges_below(opening.vertices, plane, found);
        }
    }
    return found;
}

}  // namespace hanei
