/// What holds of every mesh.
#pragma once

#include "engine/geometry/polygon.h"
#include "engine/mesh/mesh.h"

#include <gtest/gtest.h>
#include <set>

namespace hanei {

inline double area_of(const Mesh& mesh, std::size_t face) {
    double area = 0.0;
    for (std::uint32_t k = 0; k < mesh.faces[face].patch_count; ++k)
        area += mesh.patches[mesh.faces[face].first_patch + k].area;
    return area;
}

inline constexpr double rounding = 1e-7;  // m2: areas lose strips of 1e-9 of the room's diameter at every cut

inline void expect_sound(const Mesh& mesh) {
    double of_patches = 0.0;
    double of_vertices = 0.0;
    for (const Patch& patch : mesh.patches) {
        const Vec3 normal = mesh.faces[patch.face].face.normal;
        EXPECT_TRUE(is_convex(patch.outline, normal));
        EXPECT_GT(patch.area, 0.0);
        ASSERT_EQ(patch.corners.size(), patch.outline.size());
        for (std::size_t k = 0; k < patch.corners.size(); ++k) {
            EXPECT_EQ(mesh[patch.corners[k]].receiver.position, patch.outline[k]);
            EXPECT_EQ(mesh[patch.corners[k]].face, patch.face);
            const Vec3 edge = patch.outline[(k + 1) % patch.outline.size()] - patch.outline[k];
            EXPECT_GT(glm::dot(glm::cross(edge, patch.centre - patch.outline[k]), normal), 0.0);
        }
        of_patches += patch.area;
    }
    for (const Vertex& vertex : mesh.vertices) of_vertices += vertex.area;
    EXPECT_NEAR(of_patches, of_vertices, 1e-9 * of_patches);  // sums of the same numbers in another order
    std::set<VertexId> in_rows;
    for (const MeshFace& face : mesh.faces) {
        for (const VertexRow& row : face.rows) {
            for (const VertexId id : row.vertices) EXPECT_TRUE(in_rows.insert(id).second);
        }
    }
    EXPECT_EQ(in_rows.size(), mesh.vertices.size());
}

}  // namespace hanei
