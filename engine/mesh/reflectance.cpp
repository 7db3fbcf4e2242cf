#include "engine/mesh/mesh.h"

#include <map>

namespace hanei {

namespace {

/// 0 for a material the scene does not have: an error of the scene that check_scene names.
class Reflectances {
public:
    explicit Reflectances(const Scene& scene) {
        for (const Material& material : scene.materials) by_id_.emplace(material.id, material.reflectance);
    }
    double of(ObjectId material) const {
        const auto found = by_id_.find(material);
        return found == by_id_.end() ? 0.0 : found->second;
    }

private:
    std::map<ObjectId, double> by_id_;
};

}  // namespace

PerPatch<double> reflectances(const Mesh& mesh, const Scene& scene) {
    const Reflectances materials(scene);
    PerPatch<double> values(mesh.patches.size());
    for (std::size_t k = 0; k < mesh.patches.size(); ++k) {
        values[PatchId{static_cast<std::uint32_t>(k)}] = materials.of(mesh.patches[k].material);
    }
    return values;
}

std::vector<double> vertex_reflectances(const Mesh& mesh, const Scene& scene) {
    const Reflectances materials(scene);
    std::vector<double> values;
    values.reserve(mesh.vertices.size());
    for (const Vertex& vertex : mesh.vertices) values.push_back(materials.of(vertex.material));
    return values;
}

std::vector<ReflectanceRun> reflectance_runs(const Mesh& mesh, const Scene& scene, const VertexRow& row) {
    const Reflectances materials(scene);
    std::vector<ReflectanceRun> runs;
    for (std::uint32_t k = 0; k < row.vertices.size(); ++k) {
        const double reflectance = materials.of(mesh[row.vertices[k]].material);
        if (!runs.empty() && runs.back().reflectance == reflectance) {
            runs.back().last = k;
        } else {
            runs.push_back({k, k, reflectance});
        }
    }
    return runs;
}

}  // namespace hanei
