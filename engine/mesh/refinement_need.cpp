#include "engine/mesh/refinement_need.h"

#include "engine/base/check.h"
#include "engine/base/tolerance.h"
#include "engine/mesh/free_sector.h"
#include "engine/mesh/refine.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hanei {

std::vector<double> refinement_need(const Mesh& mesh, const MeshLight& light) {
    const std::size_t count = mesh.patches.size();
    std::size_t corners = 0;
    for (const Patch& patch : mesh.patches) corners += patch.corners.size();
    const bool one_a_patch = light.of_elements.size() == count;
    HANEI_CHECK(one_a_patch || light.of_elements.size() == corners);
    HANEI_CHECK(light.at_vertices.size() == mesh.vertices.size() && light.reflectance.size() == count);
    HANEI_CHECK(light.importance.empty() || light.importance.size() == count);
    std::vector<double> need(count);
    std::size_t corner = 0;
    for (std::size_t p = 0; p < count; ++p) {
        const Patch& patch = mesh.patches[p];
        double least = 0.0;
        double greatest = 0.0;
        for (const VertexId id : patch.corners) {
            const double said = light.of_elements[one_a_patch ? p : corner];
            const double missed = light.at_vertices[static_cast<std::size_t>(id)] - said;
            least = std::min(least, missed);
            greatest = std::max(greatest, missed);
            ++corner;
        }
        const double importance = light.importance.empty() ? patch.area : light.importance[p];
        const double found = importance * light.reflectance[p] * (greatest - least);
        need[p] = std::isfinite(found) ? std::max(0.0, found) : 0.0;
    }
    return need;
}

std::vector<char> patches_to_split(const Mesh& mesh, std::span<const double> need, std::size_t new_patches) {
    HANEI_CHECK(need.size() == mesh.patches.size());
    const double same_place = tolerance::same_place * diameter_of(mesh);
    std::vector<std::size_t> order(need.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return need[a] > need[b]; });
    std::vector<char> split(need.size(), 0);
    std::size_t made = 0;
    for (const std::size_t p : order) {
        if (made >= new_patches || !(need[p] > 0.0)) break;
        const Face& face = mesh.faces[mesh.patches[p].face].face;
        const Vec3 across = glm::cross(face.normal, face.along);
        const std::size_t parts = parts_of(mesh.patches[p].outline, face.along, across, same_place).size();
        if (parts < 2) continue;
        split[p] = 1;
        made += parts - 1;
    }
    return split;
}

}  // namespace hanei
