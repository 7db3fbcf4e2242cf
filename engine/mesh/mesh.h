/// Patches and vertices: the room cut up for interreflection.
///
/// Every face gets a grid by the paper's equation 5 (w = W_u / floor(W_u/W + 0.5), at least one
/// patch each way) along its longest edge; cells are cut where furniture touches the face, where a
/// sub-area begins and at the face's own outline, so that every patch is a convex polygon of one
/// reflectance that light can reach, and covered floor is in no patch.
#pragma once

#include "engine/base/progress.h"
#include "engine/geometry/configuration_factor.h"
#include "engine/geometry/occluders.h"
#include "engine/scene/faces.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace hanei {

enum class PatchId : std::uint32_t {};
enum class VertexId : std::uint32_t {};

/// Values one a patch, reached by PatchId alone.
template <class T>
class PerPatch {
public:
    PerPatch() = default;
    explicit PerPatch(std::size_t count, T value = {}) : values_(count, value) {}
    T& operator[](PatchId id) { return values_[static_cast<std::size_t>(id)]; }
    const T& operator[](PatchId id) const { return values_[static_cast<std::size_t>(id)]; }
    std::size_t size() const { return values_.size(); }
    std::span<T> all() { return values_; }
    std::span<const T> all() const { return values_; }
    bool operator==(const PerPatch&) const = default;

private:
    std::vector<T> values_;
};

/// A row of grid points on one straight line of a face: what the paper's visibility works on.
struct VertexRow {
    std::vector<VertexId> vertices;  ///< in order along the line
};

struct MeshFace {
    Face face;
    std::uint32_t first_patch = 0, patch_count = 0;    ///< patches of a face are consecutive
    std::uint32_t first_vertex = 0, vertex_count = 0;  ///< so are its vertices
    std::vector<VertexRow> rows;                       ///< every vertex of the face is in exactly one
};

struct Patch {
    std::uint32_t face = 0;         ///< index into Mesh::faces
    std::vector<VertexId> corners;  ///< convex, counter-clockwise seen from the lit side
    Polygon outline;                ///< the corners' places
    Vec3 centre{0.0};
    double area = 0.0;  ///< m2
    ObjectId material;  ///< reflectance is looked up when the balance is struck
    LuminousExitance own_exitance;
};

/// A corner of patches of one face (edges shared by two faces have vertices of both).
struct Vertex {
    std::uint32_t face = 0;
    Receiver receiver;  ///< place, normal, and the direction into its face when on the edge of it
    double area = 0.0;  ///< m2, each patch's area shared evenly among its corners: the paper's w_j A_j
    ObjectId material;
    LuminousExitance own_exitance;
};

struct Mesh {
    std::vector<MeshFace> faces;
    std::vector<Patch> patches;
    std::vector<Vertex> vertices;

    const Patch& operator[](PatchId id) const { return patches[static_cast<std::size_t>(id)]; }
    const Vertex& operator[](VertexId id) const { return vertices[static_cast<std::size_t>(id)]; }
    Receiver centre_of(const Patch& patch) const { return {patch.centre, faces[patch.face].face.normal, Vec3{0.0}}; }
};

/// How the lines of a face's grid lie.
enum class Grading : std::uint8_t {
    uniform,  ///< equally far apart: the paper's equation 5
    crowded   ///< as many, but crowding towards the face's borders, where interreflected light bends most
};

/// Meshes every face. `max_patch` is the wished patch width in metres; of a crowded grid the mean. Of the
/// objects named `black` it is wider_when_black times that.
std::shared_ptr<const Mesh> make_mesh(const Scene& scene, double max_patch, Grading grading = Grading::uniform,
                                      std::span<const ObjectId> black = {});

/// The scene's shadow casters: furniture parts as convex solids (several where a part is not convex; by
/// their faces where it cannot be cut into such), free surfaces and opaque openings as flat
/// bodies, room faces only where something of the room lies behind their plane (re-entrant corners).
/// Surfaces that together are a convex cap (a box without its bottom) become one solid.
OccluderSet occluders_of(const Scene& scene);

/// Reflectance of every patch / vertex, from the scene's materials.
PerPatch<double> reflectances(const Mesh& mesh, const Scene& scene);
std::vector<double> vertex_reflectances(const Mesh& mesh, const Scene& scene);

/// A run of equal reflectance in a row of grid points: the paper's run-length code.
struct ReflectanceRun {
    std::uint32_t first = 0, last = 0;  ///< positions in the row, both included
    double reflectance = 0.0;
};
std::vector<ReflectanceRun> reflectance_runs(const Mesh& mesh, const Scene& scene, const VertexRow& row);

/// A receiver for a place and normal anywhere: when it lies on a mesh face facing the same way, on
/// that face with the direction inward; else free. Also names the face (-1: none).
struct LocatedReceiver {
    Receiver receiver;
    int face = -1;
};
LocatedReceiver locate(const Mesh& mesh, const Vec3& position, const Vec3& normal);

}  // namespace hanei
