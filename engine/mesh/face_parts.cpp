#include "engine/mesh/face_parts.h"

#include "engine/geometry/polygon.h"

#include <algorithm>
#include <map>

namespace hanei {

std::optional<Patch> patch_of(const MeshFace& face, const Polygon& outline, PlaceIndex& places, double same_place) {
    Patch patch;
    for (const Vec3& corner : outline) {
        const VertexId id{face.first_vertex + places.number_of(corner)};
        if (std::find(patch.corners.begin(), patch.corners.end(), id) != patch.corners.end()) continue;
        patch.corners.push_back(id);
        patch.outline.push_back(places.places()[static_cast<std::uint32_t>(id) - face.first_vertex]);
    }
    if (patch.corners.size() < 3) return std::nullopt;
    patch.area = glm::dot(vector_area(patch.outline), face.face.normal);
    if (patch.area <= same_place * diameter(patch.outline)) return std::nullopt;
    patch.centre = centroid(patch.outline);
    patch.own_exitance = face.face.own_exitance;
    return patch;
}

void add_vertices(Mesh& mesh, MeshFace& face, std::span<const Vec3> places) {
    for (const Vec3& place : places) {
        Vertex vertex;
        vertex.face = static_cast<std::uint32_t>(mesh.faces.size());
        vertex.receiver = {place, face.face.normal, Vec3(0.0)};
        vertex.material = face.face.material;
        vertex.own_exitance = face.face.own_exitance;
        mesh.vertices.push_back(vertex);
    }
    std::vector<std::map<ObjectId, double>> shares(places.size());
    for (std::size_t p = face.first_patch; p < mesh.patches.size(); ++p) {
        const Patch& patch = mesh.patches[p];
        const double share = patch.area / static_cast<double>(patch.corners.size());
        for (const VertexId corner : patch.corners) {
            mesh.vertices[static_cast<std::size_t>(corner)].area += share;
            shares[static_cast<std::uint32_t>(corner) - face.first_vertex][patch.material] += share;
        }
    }
    for (std::size_t k = 0; k < shares.size(); ++k) {
        double greatest = 0.0;
        for (const auto& [material, share] : shares[k]) {
            if (share <= greatest * (1.0 + 1e-9)) continue;  // shares equal but for rounding
            greatest = share;
            mesh.vertices[face.first_vertex + k].material = material;
        }
    }
    face.vertex_count = static_cast<std::uint32_t>(shares.size());
}

std::vector<VertexRow> rows_of(const Mesh& mesh, const MeshFace& face, double same_place) {
    const Vec3 across = glm::cross(face.face.normal, face.face.along);
    struct Placed {
        double u, v;
        VertexId id;
    };
    std::vector<Placed> placed;
    for (std::uint32_t k = 0; k < face.vertex_count; ++k) {
        const Vec3& place = mesh.vertices[face.first_vertex + k].receiver.position;
        placed.push_back({glm::dot(place, face.face.along), glm::dot(place, across), VertexId{face.first_vertex + k}});
    }
    std::sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) { return a.v < b.v; });
    std::vector<VertexRow> rows;
    for (std::size_t first = 0; first < placed.size();) {
        std::size_t last = first + 1;
        while (last < placed.size() && placed[last].v - placed[first].v <= 4.0 * same_place) ++last;
        std::sort(placed.begin() + static_cast<std::ptrdiff_t>(first),
                  placed.begin() + static_cast<std::ptrdiff_t>(last),
                  [](const Placed& a, const Placed& b) { return a.u < b.u; });
        VertexRow& row = rows.emplace_back();
        for (std::size_t k = first; k < last; ++k) row.vertices.push_back(placed[k].id);
        first = last;
    }
    return rows;
}

}  // namespace hanei
