#include "engine/transport/seen_face.h"

#include "engine/base/tolerance.h"
#include "engine/geometry/polygon.h"

#include <algorithm>
#include <limits>
#include <map>

namespace hanei {

namespace {

FlatBox box_of(const FaceLayout& layout, const Polygon& polygon) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    FlatBox box{infinite, infinite, -infinite, -infinite};
    for (const Vec3& place : polygon) {
        const double u = glm::dot(place, layout.along);
        const double v = glm::dot(place, layout.across);
        box = {std::min(box.low_u, u), std::min(box.low_v, v), std::max(box.high_u, u), std::max(box.high_v, v)};
    }
    return box;
}

/// The outline when it is convex, else the rectangle around it.
std::vector<Vec3> convex_around(const FaceLayout& layout, const Face& face) {
    const Polygon& outline = face.region.outline;
    if (is_convex(outline, face.normal)) return outline;
    const FlatBox box = box_of(layout, outline);
    const Vec3 base = glm::dot(outline.front(), face.normal) * face.normal;
    const auto place = [&](double u, double v) { return base + u * layout.along + v * layout.across; };
    return {place(box.low_u, box.low_v), place(box.high_u, box.low_v), place(box.high_u, box.high_v),
            place(box.low_u, box.high_v)};
}

void add_boxes(FaceLayout& layout, const Mesh& mesh) {
    for (std::uint32_t p = 0; p < layout.face->patch_count; ++p) {
        const FlatBox box = box_of(layout, mesh.patches[layout.face->first_patch + p].outline);
        layout.boxes.push_back(box);
        if (p % FaceLayout::group_size == 0) layout.group_boxes.push_back(box);
        FlatBox& group = layout.group_boxes.back();
        group = {std::min(group.low_u, box.low_u), std::min(group.low_v, box.low_v), std::max(group.high_u, box.high_u),
                 std::max(group.high_v, box.high_v)};
    }
}

FaceLayout layout_of(const Mesh& mesh, const MeshFace& face, double same_place) {
    FaceLayout layout;
    layout.face = &face;
    layout.along = face.face.along;
    layout.across = glm::cross(face.face.normal, face.face.along);
    layout.corners = convex_around(layout, face.face);
    layout.same_place = same_place;
    add_boxes(layout, mesh);
    for (std::uint32_t k = 0; k < face.vertex_count; ++k) {
        layout.vertices.push_back(mesh.vertices[face.first_vertex + k].receiver.position);
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::int32_t> numbers;
    layout.first_edge.push_back(0);
    for (std::uint32_t p = 0; p < face.patch_count; ++p) {
        const std::vector<VertexId>& corners = mesh.patches[face.first_patch + p].corners;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const auto from = static_cast<std::uint32_t>(corners[k]) - face.first_vertex;
            const auto to = static_cast<std::uint32_t>(corners[(k + 1) % corners.size()]) - face.first_vertex;
            const auto [at, is_new] =
                numbers.emplace(std::minmax(from, to), static_cast<std::int32_t>(layout.edges.size()) + 1);
            if (is_new) layout.edges.push_back({std::min(from, to), std::max(from, to)});
            layout.edges_of.push_back(from < to ? at->second : -at->second);
        }
        layout.first_edge.push_back(static_cast<std::uint32_t>(layout.edges_of.size()));
    }
    return layout;
}

}  // namespace

std::vector<FaceLayout> layouts_of(const Mesh& mesh) {
    Vec3 low(std::numeric_limits<double>::infinity());
    Vec3 high = -low;
    for (const Vertex& vertex : mesh.vertices) {
        low = glm::min(low, vertex.receiver.position);
        high = glm::max(high, vertex.receiver.position);
    }
    const double same_place = mesh.vertices.empty() ? 0.0 : tolerance::same_place * glm::length(high - low);
    std::vector<FaceLayout> layouts;
    for (const MeshFace& face : mesh.faces) {
        if (face.patch_count > 0) layouts.push_back(layout_of(mesh, face, same_place));
    }
    return layouts;
}

FaceSeen seen_from(const FaceLayout& layout, const Receiver& receiver) {
    const Vec3& front = layout.face->face.normal;
    const double height = glm::dot(receiver.position - layout.corners.front(), front);
    if (height < -layout.same_place) return FaceSeen::hidden;
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (const Vec3& corner : layout.corners) {
        const double over_horizon = glm::dot(corner - receiver.position, receiver.normal);
        lowest = std::min(lowest, over_horizon);
        highest = std::max(highest, over_horizon);
    }
    // In the receiver's own plane nothing is seen, a sheet's back to back side least of all.
    if (highest <= layout.same_place) return FaceSeen::hidden;
    // Heights under a few tolerances are left to the kernel that knows the limit in the plane.
    if (height <= 8.0 * layout.same_place) return FaceSeen::touching;
    return lowest >= 0.0 ? FaceSeen::wholly : FaceSeen::partly;
}

bool reaches(const Patch& patch, const Vec3& place, double same_place) {
    Vec3 low = patch.outline.front();
    Vec3 high = low;
    for (const Vec3& corner : patch.outline) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    const Vec3 beyond = glm::max(low - place, place - high);
    return std::max({beyond.x, beyond.y, beyond.z}) <= 16.0 * same_place;
}

}  // namespace hanei
