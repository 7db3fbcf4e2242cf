#include "engine/mesh/hanging.h"

#include "engine/mesh/refine.h"
#include "tests/unit/mesh/sample_scenes.h"

#include <cmath>
#include <gtest/gtest.h>

namespace hanei {
namespace {

/// The greatest jump where patches meet: a vertex on a patch's edge against the line between its ends.
double greatest_jump(const Mesh& mesh, const std::vector<double>& values) {
    double greatest = 0.0;
    for (const Patch& patch : mesh.patches) {
        const MeshFace& face = mesh.faces[patch.face];
        for (std::size_t k = 0; k < patch.corners.size(); ++k) {
            const VertexId from = patch.corners[k];
            const VertexId to = patch.corners[(k + 1) % patch.corners.size()];
            const Vec3 start = mesh[from].receiver.position;
            const Vec3 edge = mesh[to].receiver.position - start;
            for (std::uint32_t v = face.first_vertex; v < face.first_vertex + face.vertex_count; ++v) {
                const Vec3 off = mesh.vertices[v].receiver.position - start;
                const double share = glm::dot(off, edge) / glm::dot(edge, edge);
                if (share <= 0.0 || share >= 1.0 || glm::length(off - share * edge) > 1e-7) continue;
                const double drawn = (1.0 - share) * values[static_cast<std::size_t>(from)] +
                                     share * values[static_cast<std::size_t>(to)];
                greatest = std::max(greatest, std::abs(values[v] - drawn));
            }
        }
    }
    return greatest;
}

std::vector<double> any_values(const Mesh& mesh) {
    std::vector<double> values;
    for (std::size_t k = 0; k < mesh.vertices.size(); ++k) values.push_back(std::sin(12.9898 * static_cast<double>(k)));
    return values;
}

void hang(std::vector<double>& values, const std::vector<HangingVertex>& hanging) {
    const auto at = [&](VertexId id) -> double& { return values[static_cast<std::size_t>(id)]; };
    for (const HangingVertex& h : hanging) at(h.vertex) = (1.0 - h.share) * at(h.from) + h.share * at(h.to);
}

TEST(Hanging, a_grid_has_no_hanging_vertices) {
    EXPECT_TRUE(hanging_vertices(*make_mesh(sample::box_room(4.0, 3.0, 2.5), 0.5)).empty());
}

TEST(Hanging, a_patch_cut_in_four_hangs_in_the_middle_of_its_neighbours_edges) {
    const auto coarse = make_mesh(sample::box_room(4.0, 3.0, 2.5), 0.5);
    std::vector<char> split(coarse->patches.size(), 0);
    split[9] = 1;  // the second patch of the floor's second row
    const RefinedMesh fine = refined(*coarse, split);
    const std::vector<HangingVertex> hanging = hanging_vertices(*fine.mesh);
    ASSERT_EQ(hanging.size(), 4U);
    for (const HangingVertex& h : hanging) {
        EXPECT_NEAR(h.share, 0.5, 1e-12);
        const Vec3 middle = 0.5 * ((*fine.mesh)[h.from].receiver.position + (*fine.mesh)[h.to].receiver.position);
        EXPECT_NEAR(glm::length((*fine.mesh)[h.vertex].receiver.position - middle), 0.0, 1e-12);
    }
}

TEST(Hanging, a_furnished_room_refined_unequally_is_drawn_without_jumps) {
    std::shared_ptr<const Mesh> mesh = make_mesh(sample::computer_room(), 0.6);
    for (std::size_t round = 0; round < 3; ++round) {
        std::vector<char> split(mesh->patches.size(), 0);
        for (std::size_t p = round; p < split.size(); p += 4) split[p] = 1;
        mesh = refined(*mesh, split).mesh;
    }
    std::vector<double> values = any_values(*mesh);
    EXPECT_GT(greatest_jump(*mesh, values), 0.5);
    hang(values, hanging_vertices(*mesh));
    EXPECT_LT(greatest_jump(*mesh, values), 1e-7);  // places are the same to 4e-8 m, edges are longer than 0.1 m
}

/// Four patches around a square in the middle, each leaning on the next.
Mesh pinwheel() {
    Mesh mesh;
    MeshFace face;
    face.face.normal = {0.0, 0.0, 1.0};
    face.face.along = {1.0, 0.0, 0.0};
    face.face.region.outline = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}};
    const std::vector<Vec3> places = {{0, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 2, 0}, {3, 3, 0}, {1, 3, 0},
                                      {0, 3, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}};
    for (const Vec3& place : places) {
        Vertex vertex;
        vertex.receiver.position = place;
        mesh.vertices.push_back(vertex);
    }
    for (const std::vector<std::uint32_t>& corners : std::vector<std::vector<std::uint32_t>>{
             {0, 1, 9, 7}, {1, 2, 3, 10}, {3, 4, 5, 11}, {5, 6, 7, 8}, {8, 9, 10, 11}}) {
        Patch patch;
        for (const std::uint32_t corner : corners) {
            patch.corners.push_back(VertexId{corner});
            patch.outline.push_back(places[corner]);
            patch.centre += places[corner] / 4.0;
        }
        mesh.patches.push_back(patch);
    }
    face.patch_count = static_cast<std::uint32_t>(mesh.patches.size());
    face.vertex_count = static_cast<std::uint32_t>(places.size());
    mesh.faces.push_back(face);
    return mesh;
}

TEST(Hanging, of_vertices_that_hang_on_each_other_in_a_ring_one_keeps_its_value) {
    const Mesh mesh = pinwheel();
    const std::vector<HangingVertex> hanging = hanging_vertices(mesh);
    EXPECT_EQ(hanging.size(), 3U);  // of the square's four corners
    std::vector<double> values = any_values(mesh);
    hang(values, hanging);
    for (const double value : values) EXPECT_TRUE(std::isfinite(value));
}

}  // namespace
}  // namespace hanei
