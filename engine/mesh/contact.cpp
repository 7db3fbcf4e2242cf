#include "engine/mesh/contact.h"

#include "engine/base/tolerance.h"
#include "engine/geometry/polygon.h"
#include "engine/mesh/pieces.h"

#include <algorithm>
#include <limits>
#include <map>

namespace hanei {

namespace {

struct Heights {
    double least = std::numeric_limits<double>::infinity();
    double greatest = -std::numeric_limits<double>::infinity();
};

Heights heights_over(const Plane& plane, std::span<const Vec3> points) {
    Heights found;
    for (const Vec3& point : points) {
        found.least = std::min(found.least, plane.height(point));
        found.greatest = std::max(found.greatest, plane.height(point));
    }
    return found;
}

Plane plane_of(const Face& face) { return {face.region.outline.front(), face.normal}; }

/// The rectangle around a face, in its plane, a little larger than it.
Polygon around(const Face& face) {
    const Vec3 across = glm::cross(face.normal, face.along);
    const Vec3 origin = face.region.outline.front();
    Heights u;
    Heights v;
    for (const Vec3& corner : face.region.outline) {
        const double a = glm::dot(corner - origin, face.along);
        const double b = glm::dot(corner - origin, across);
        u = {std::min(u.least, a), std::max(u.greatest, a)};
        v = {std::min(v.least, b), std::max(v.greatest, b)};
    }
    const double margin = 0.01 * (u.greatest - u.least + v.greatest - v.least);
    u = {u.least - margin, u.greatest + margin};
    v = {v.least - margin, v.greatest + margin};
    return {origin + u.least * face.along + v.least * across, origin + u.greatest * face.along + v.least * across,
            origin + u.greatest * face.along + v.greatest * across,
            origin + u.least * face.along + v.greatest * across};
}

}  // namespace

Contacts::Contacts(const Scene& scene)
    : faces_(faces_of(scene)),
      openings_(opaque_openings(scene)),
      same_place_(tolerance::same_place * bounds_of(scene).diameter()) {
    for (const Face& face : faces_) {
        pieces_.push_back(pieces_of(face.region, face.normal));
        is_of_room_.push_back(scene.room && face.ref.object == scene.room->id);
    }
    std::map<SurfaceRef, std::size_t> numbers;
    for (std::size_t f = 0; f < faces_.size(); ++f) numbers.emplace(faces_[f].ref, f);
    for (Solid& solid : solids_of(scene)) {
        SolidBody part;
        for (const int face : solid.surface) {
            const auto at = numbers.find({solid.object, face});
            if (at != numbers.end()) part.faces.push_back(at->second);
        }
        part.shell = solid.shell;
        part.body = {std::move(solid.vertices), std::move(solid.faces), solid.object.value};
        solids_.push_back(std::move(part));
    }
    for (SolidBody& cap : convex_caps(scene, faces_, same_place_)) solids_.push_back(std::move(cap));
    solid_of_.assign(faces_.size(), -1);
    for (std::size_t s = 0; s < solids_.size(); ++s) {
        for (const std::size_t f : solids_[s].faces) solid_of_[f] = static_cast<int>(s);
    }
}

std::optional<Polygon> Contacts::section(std::size_t face, const ConvexBody& solid) const {
    Polygon left = around(faces_[face]);
    for (const auto& loop : solid.faces) {
        Polygon side;
        for (const int v : loop) side.push_back(solid.vertices[static_cast<std::size_t>(v)]);
        const Vec3 normal = unit_normal(side);
        if (std::abs(glm::dot(normal, faces_[face].normal)) > 1.0 - tolerance::parallel) continue;
        left = clipped(left, {side.front(), -normal}, same_place_);
        if (left.empty()) return std::nullopt;
    }
    return left;
}

bool Contacts::solid_covers(std::size_t face, const SolidBody& solid, int number) const {
    const Heights h = heights_over(plane_of(faces_[face]), solid.body.vertices);
    if (h.least > same_place_ || h.greatest < -same_place_) return false;
    if (h.greatest > same_place_) return true;                // it stands on the face or goes through it
    return solid_of_[face] >= 0 && number > solid_of_[face];  // two solids' faces in one plane
}

bool Contacts::sheet_covers(std::size_t face, std::size_t sheet) const {
    const Heights h = heights_over(plane_of(faces_[face]), faces_[sheet].region.outline);
    if (h.least < -same_place_ || h.greatest > same_place_) return false;
    if (solid_of_[face] >= 0) return true;
    if (glm::dot(faces_[face].normal, faces_[sheet].normal) > 0.0) return sheet > face;
    return is_of_room_[face] != is_of_room_[sheet];
}

bool Contacts::is_skin_of(std::size_t face, std::size_t solid) const {
    if (solid_of_[face] < 0) return false;
    const auto own = static_cast<std::size_t>(solid_of_[face]);
    return own == solid || (solids_[own].shell && solids_[own].shell == solids_[solid].shell);
}

std::vector<Polygon> Contacts::covers_of(std::size_t face) const {
    std::vector<Polygon> found;
    for (std::size_t s = 0; s < solids_.size(); ++s) {
        if (is_skin_of(face, s) || !solid_covers(face, solids_[s], static_cast<int>(s))) continue;
        if (auto polygon = section(face, solids_[s].body)) found.push_back(std::move(*polygon));
    }
    for (std::size_t g = 0; g < faces_.size(); ++g) {
        if (g == face || solid_of_[g] >= 0 || !sheet_covers(face, g)) continue;
        found.insert(found.end(), pieces_[g].begin(), pieces_[g].end());
    }
    const Plane plane = plane_of(faces_[face]);
    for (const ConvexBody& opening : openings_) {
        const Heights h = heights_over(plane, opening.vertices);
        if (h.least < -same_place_ && h.greatest <= same_place_) continue;  // behind
        if (h.least > same_place_) continue;
        if (opening.faces.size() > 1) {
            if (auto polygon = section(face, opening)) found.push_back(std::move(*polygon));
        } else if (h.greatest <= same_place_) {
            found.push_back(opening.vertices);
        }
    }
    for (Polygon& cover : found) {
        if (glm::dot(vector_area(cover), faces_[face].normal) < 0.0) std::reverse(cover.begin(), cover.end());
    }
    return found;
}

}  // namespace hanei
