#include "engine/mesh/refine.h"

#include "engine/base/check.h"
#include "engine/base/tolerance.h"
#include "engine/geometry/polygon.h"
#include "engine/mesh/face_parts.h"
#include "engine/mesh/free_sector.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace hanei {

namespace {

constexpr double long_patch = 1.99;      // twice as long as wide, but for rounding: two squares
constexpr double near_a_corner = 0.1;    // of the width: a strip between cut and corner would be a sliver
constexpr double smallest_part = 0.125;  // of what is cut in two: half of what a triangle's tip may be

struct Extent {
    double low, high;
    double width() const { return high - low; }
};

Extent extent_of(const Polygon& polygon, const Vec3& direction) {
    Extent extent{glm::dot(polygon.front(), direction), glm::dot(polygon.front(), direction)};
    for (const Vec3& corner : polygon) {
        const double at = glm::dot(corner, direction);
        extent = {std::min(extent.low, at), std::max(extent.high, at)};
    }
    return extent;
}

/// A place in the middle of the polygon's extent along a direction, or at a corner near there.
Vec3 middle_along(const Polygon& polygon, const Vec3& direction) {
    const Extent extent = extent_of(polygon, direction);
    const double middle = 0.5 * (extent.low + extent.high);
    double nearest = near_a_corner * extent.width();
    Vec3 place = polygon.front() + (middle - glm::dot(polygon.front(), direction)) * direction;
    for (const Vec3& corner : polygon) {
        const double off = std::abs(glm::dot(corner, direction) - middle);
        if (off >= nearest) continue;
        nearest = off;
        place = corner;
    }
    return place;
}

/// The parts before and behind a place along a direction; the whole when one would be too small.
std::vector<Polygon> halves_of(const Polygon& polygon, const Vec3& place, const Vec3& direction, double same_place) {
    Polygon before = clipped(polygon, {place, -direction}, same_place);
    Polygon behind = clipped(polygon, {place, direction}, same_place);
    const double least = smallest_part * glm::length(vector_area(polygon));
    const auto sound = [&](const Polygon& part) {
        if (part.size() < 3) return false;
        const double area = glm::length(vector_area(part));
        return area >= least && area > 4.0 * same_place * diameter(part);  // else too thin to be a patch
    };
    if (!sound(before) || !sound(behind)) return {polygon};
    return {std::move(before), std::move(behind)};
}

class Refiner {
public:
    Refiner(const Mesh& coarse, const PatchParts& parts)
        : coarse_(coarse), parts_(parts), same_place_(tolerance::same_place * diameter_of(coarse)) {}

    RefinedMesh build() {
        for (const MeshFace& face : coarse_.faces) add_face(face);
        return {std::make_shared<const Mesh>(std::move(mesh_)), std::move(origin_)};
    }

private:
    void add_face(const MeshFace& before) {
        MeshFace face;
        face.face = before.face;
        face.first_patch = static_cast<std::uint32_t>(mesh_.patches.size());
        face.first_vertex = static_cast<std::uint32_t>(mesh_.vertices.size());
        PlaceIndex places(4.0 * same_place_);
        for (std::uint32_t k = 0; k < before.vertex_count; ++k)
            places.number_of(coarse_.vertices[before.first_vertex + k].receiver.position);
        for (std::uint32_t p = before.first_patch; p < before.first_patch + before.patch_count; ++p)
            add_patch(face, p, places);
        face.patch_count = static_cast<std::uint32_t>(mesh_.patches.size()) - face.first_patch;
        add_vertices(mesh_, face, places.places());
        turn_inward(face, before);
        face.rows = rows_of(mesh_, face, same_place_);
        mesh_.faces.push_back(std::move(face));
    }

    void add_patch(const MeshFace& face, std::uint32_t number, PlaceIndex& places) {
        const Patch& whole = coarse_.patches[number];
        for (const Polygon& part : parts_(PatchId{number})) {
            auto patch = patch_of(face, part, places, same_place_);
            if (!patch) patch = patch_of(face, whole.outline, places, same_place_);
            if (!patch) continue;
            patch->face = whole.face;
            patch->material = whole.material;
            patch->own_exitance = whole.own_exitance;
            mesh_.patches.push_back(std::move(*patch));
            origin_.push_back(PatchId{number});
        }
    }

    /// Vertices of the coarse mesh have the same patches around them, in parts. A new one is on a
    /// border only when it lies on an edge that no two patches share.
    void turn_inward(const MeshFace& face, const MeshFace& before) {
        for (std::uint32_t k = 0; k < before.vertex_count; ++k) {
            mesh_.vertices[face.first_vertex + k].receiver.inward =
                coarse_.vertices[before.first_vertex + k].receiver.inward;
        }
        const std::set<Edge> edges = edges_of(before);
        const SectorFinder sectors(coarse_, before);
        for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p) {
            const Patch& whole = coarse_[origin_[p]];
            for (const VertexId corner : mesh_.patches[p].corners) {
                if (static_cast<std::uint32_t>(corner) < face.first_vertex + before.vertex_count) continue;
                Receiver& receiver = mesh_.vertices[static_cast<std::size_t>(corner)].receiver;
                if (!is_on_open_edge(whole, edges, receiver.position)) continue;
                receiver.inward = sectors.at(receiver.position, 4.0 * same_place_).inward;
            }
        }
    }

    using Edge = std::pair<VertexId, VertexId>;

    std::set<Edge> edges_of(const MeshFace& face) const {
        std::set<Edge> edges;
        for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p) {
            const std::vector<VertexId>& corners = coarse_.patches[p].corners;
            for (std::size_t k = 0; k < corners.size(); ++k)
                edges.emplace(corners[k], corners[(k + 1) % corners.size()]);
        }
        return edges;
    }

    bool is_on_open_edge(const Patch& patch, const std::set<Edge>& edges, const Vec3& place) const {
        for (std::size_t k = 0; k < patch.corners.size(); ++k) {
            const std::size_t next = (k + 1) % patch.corners.size();
            if (edges.count({patch.corners[next], patch.corners[k]})) continue;
            const Vec3 along = glm::normalize(patch.outline[next] - patch.outline[k]);
            const Vec3 off = place - patch.outline[k];
            if (glm::length(off - glm::dot(off, along) * along) <= 4.0 * same_place_) return true;
        }
        return false;
    }

    const Mesh& coarse_;
    const PatchParts& parts_;
    double same_place_;
    Mesh mesh_;
    std::vector<PatchId> origin_;
};

}  // namespace

std::vector<Polygon> parts_of(const Polygon& patch, const Vec3& along, const Vec3& across, double same_place) {
    const double length = extent_of(patch, along).width();
    const double width = extent_of(patch, across).width();
    const Vec3 in_length = middle_along(patch, along);
    const Vec3 in_width = middle_along(patch, across);
    if (length >= long_patch * width) return halves_of(patch, in_length, along, same_place);
    std::vector<Polygon> parts;
    for (const Polygon& row : halves_of(patch, in_width, across, same_place)) {
        if (width >= long_patch * length) {
            parts.push_back(row);
            continue;
        }
        for (Polygon& part : halves_of(row, in_length, along, same_place)) parts.push_back(std::move(part));
    }
    return parts;
}

RefinedMesh refined(const Mesh& coarse, std::span<const char> split) {
    HANEI_CHECK(split.size() == coarse.patches.size());
    const double same_place = tolerance::same_place * diameter_of(coarse);
    return in_parts(coarse, [&](PatchId id) -> std::vector<Polygon> {
        const Patch& patch = coarse[id];
        if (!split[static_cast<std::size_t>(id)]) return {patch.outline};
        const Face& face = coarse.faces[patch.face].face;
        return parts_of(patch.outline, face.along, glm::cross(face.normal, face.along), same_place);
    });
}

RefinedMesh in_parts(const Mesh& coarse, const PatchParts& parts) { return Refiner(coarse, parts).build(); }

}  // namespace hanei
