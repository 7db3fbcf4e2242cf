#include "engine/mesh/mesh.h"

#include "engine/geometry/polygon.h"
#include "engine/mesh/cells.h"
#include "engine/mesh/contact.h"
#include "engine/mesh/free_sector.h"
#include "engine/mesh/place_index.h"

#include <algorithm>
#include <map>

namespace hanei {

namespace {

/// True when the place lies on an edge of the loop.
bool on_edge(const Polygon& loop, const Vec3& place, double same_place) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec3 edge = loop[(k + 1) % loop.size()] - loop[k];
        const double length = glm::length(edge);
        if (length <= 0.0) continue;
        const double along = std::clamp(glm::dot(place - loop[k], edge) / (length * length), 0.0, 1.0);
        if (glm::length(place - loop[k] - along * edge) <= same_place) return true;
    }
    return false;
}

class MeshBuilder {
public:
    MeshBuilder(const Scene& scene, double max_patch) : contacts_(scene), max_patch_(max_patch) {}

    Mesh build() {
        for (std::size_t f = 0; f < contacts_.faces().size(); ++f) add_face(f);
        return std::move(mesh_);
    }

private:
    void add_face(std::size_t f) {
        MeshFace face;
        face.face = contacts_.faces()[f];
        face.first_patch = static_cast<std::uint32_t>(mesh_.patches.size());
        face.first_vertex = static_cast<std::uint32_t>(mesh_.vertices.size());
        const std::vector<Polygon> covers = contacts_.covers_of(f);
        PlaceIndex places(4.0 * contacts_.same_place());  // a cut corner may be off by the cut's own tolerance
        const std::vector<Crease> creases = contacts_.creases_of(f);
        const double thickness = contacts_.same_place();
        for (const Cell& cell : cells_of(face.face, covers, creases, max_patch_, thickness)) {
            add_patch(face, cell, places);
        }
        face.patch_count = static_cast<std::uint32_t>(mesh_.patches.size()) - face.first_patch;
        add_vertices(face, places);
        turn_inward(face, covers);
        add_rows(face);
        mesh_.faces.push_back(std::move(face));
    }

    void add_patch(const MeshFace& face, const Cell& cell, PlaceIndex& places) {
        Patch patch;
        for (const Vec3& corner : cell.outline) {
            const VertexId id{face.first_vertex + places.number_of(corner)};
            if (std::find(patch.corners.begin(), patch.corners.end(), id) != patch.corners.end()) continue;
            patch.corners.push_back(id);
            patch.outline.push_back(places.places()[static_cast<std::uint32_t>(id) - face.first_vertex]);
        }
        patch.area = glm::dot(vector_area(patch.outline), face.face.normal);
        if (patch.corners.size() < 3 || patch.area <= contacts_.same_place() * diameter(patch.outline)) return;
        patch.face = static_cast<std::uint32_t>(mesh_.faces.size());
        patch.centre = centroid(patch.outline);
        patch.material = cell.material;
        patch.own_exitance = face.face.own_exitance;
        mesh_.patches.push_back(std::move(patch));
    }

    /// Vertices of the face with their shares of area. Of the materials that meet at a vertex, the
    /// one with the greatest share is the vertex's; of equal shares the first.
    void add_vertices(MeshFace& face, const PlaceIndex& places) {
        std::vector<std::map<ObjectId, double>> shares(places.places().size());
        for (const Vec3& place : places.places()) {
            Vertex vertex;
            vertex.face = static_cast<std::uint32_t>(mesh_.faces.size());
            vertex.receiver = {place, face.face.normal, Vec3(0.0)};
            vertex.material = face.face.material;
            vertex.own_exitance = face.face.own_exitance;
            mesh_.vertices.push_back(vertex);
        }
        for (std::size_t p = face.first_patch; p < mesh_.patches.size(); ++p) {
            const Patch& patch = mesh_.patches[p];
            const double share = patch.area / static_cast<double>(patch.corners.size());
            for (const VertexId corner : patch.corners) {
                mesh_.vertices[static_cast<std::size_t>(corner)].area += share;
                shares[static_cast<std::uint32_t>(corner) - face.first_vertex][patch.material] += share;
            }
        }
        for (std::size_t k = 0; k < shares.size(); ++k) {
            double greatest = 0.0;
            for (const auto& [material, share] : shares[k]) {
                if (share <= greatest * (1.0 + 1e-9)) continue;  // shares equal but for rounding
                greatest = share;
                mesh_.vertices[face.first_vertex + k].material = material;
            }
        }
        face.vertex_count = static_cast<std::uint32_t>(shares.size());
    }

    void turn_inward(const MeshFace& face, const std::vector<Polygon>& covers) {
        const double near = 4.0 * contacts_.same_place();
        for (std::uint32_t k = 0; k < face.vertex_count; ++k) {
            Receiver& receiver = mesh_.vertices[face.first_vertex + k].receiver;
            const auto touches = [&](const Polygon& loop) { return on_edge(loop, receiver.position, near); };
            const Region& region = face.face.region;
            if (touches(region.outline) || std::any_of(region.holes.begin(), region.holes.end(), touches) ||
                std::any_of(covers.begin(), covers.end(), touches)) {
                receiver.inward = free_sector(mesh_, face, receiver.position, near).inward;
            }
        }
    }

    /// Vertices on one line along the face are a row: lines of the grid, and between them the
    /// corners that cuts have left.
    void add_rows(MeshFace& face) const {
        const Vec3 across = glm::cross(face.face.normal, face.face.along);
        struct Placed {
            double u, v;
            VertexId id;
        };
        std::vector<Placed> placed;
        for (std::uint32_t k = 0; k < face.vertex_count; ++k) {
            const Vec3& place = mesh_.vertices[face.first_vertex + k].receiver.position;
            placed.push_back(
                {glm::dot(place, face.face.along), glm::dot(place, across), VertexId{face.first_vertex + k}});
        }
        std::sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) { return a.v < b.v; });
        for (std::size_t first = 0; first < placed.size();) {
            std::size_t last = first + 1;
            while (last < placed.size() && placed[last].v - placed[first].v <= 4.0 * contacts_.same_place()) ++last;
            std::sort(placed.begin() + static_cast<std::ptrdiff_t>(first),
                      placed.begin() + static_cast<std::ptrdiff_t>(last),
                      [](const Placed& a, const Placed& b) { return a.u < b.u; });
            VertexRow row;
            for (std::size_t k = first; k < last; ++k) row.vertices.push_back(placed[k].id);
            face.rows.push_back(std::move(row));
            first = last;
        }
    }

    Contacts contacts_;
    double max_patch_;
    Mesh mesh_;
};

}  // namespace

std::shared_ptr<const Mesh> make_mesh(const Scene& scene, double max_patch) {
    return std::make_shared<const Mesh>(MeshBuilder(scene, max_patch).build());
}

}  // namespace hanei
