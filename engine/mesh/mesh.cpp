#include "engine/mesh/mesh.h"

#include "engine/geometry/polygon.h"
#include "engine/mesh/cells.h"
#include "engine/mesh/contact.h"
#include "engine/mesh/face_parts.h"
#include "engine/mesh/free_sector.h"
#include "engine/mesh/place_index.h"
#include "engine/plan/plan.h"

#include <algorithm>

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
    MeshBuilder(const Scene& scene, double max_patch, Grading grading, std::span<const ObjectId> black)
        : contacts_(scene), max_patch_(max_patch), grading_(grading), black_(black) {}

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
        const bool is_black = std::find(black_.begin(), black_.end(), face.face.ref.object) != black_.end();
        const double width = is_black ? wider_when_black * max_patch_ : max_patch_;
        for (const Cell& cell : cells_of(face.face, covers, creases, width, grading_, thickness)) {
            if (auto patch = patch_of(face, cell.outline, places, contacts_.same_place())) {
                patch->face = static_cast<std::uint32_t>(mesh_.faces.size());
                patch->material = cell.material;
                mesh_.patches.push_back(std::move(*patch));
            }
        }
        face.patch_count = static_cast<std::uint32_t>(mesh_.patches.size()) - face.first_patch;
        add_vertices(mesh_, face, places.places());
        turn_inward(face, covers);
        face.rows = rows_of(mesh_, face, contacts_.same_place());
        mesh_.faces.push_back(std::move(face));
    }

    void turn_inward(const MeshFace& face, const std::vector<Polygon>& covers) {
        const double near = 4.0 * contacts_.same_place();
        const SectorFinder sectors(mesh_, face);
        for (std::uint32_t k = 0; k < face.vertex_count; ++k) {
            Receiver& receiver = mesh_.vertices[face.first_vertex + k].receiver;
            const auto touches = [&](const Polygon& loop) { return on_edge(loop, receiver.position, near); };
            const Region& region = face.face.region;
            if (touches(region.outline) || std::any_of(region.holes.begin(), region.holes.end(), touches) ||
                std::any_of(covers.begin(), covers.end(), touches)) {
                receiver.inward = sectors.at(receiver.position, near).inward;
            }
        }
    }

    Contacts contacts_;
    double max_patch_;
    Grading grading_;
    std::span<const ObjectId> black_;
    Mesh mesh_;
};

}  // namespace

std::shared_ptr<const Mesh> make_mesh(const Scene& scene, double max_patch, Grading grading,
                                      std::span<const ObjectId> black) {
    return std::make_shared<const Mesh>(MeshBuilder(scene, max_patch, grading, black).build());
}

}  // namespace hanei
