#include "engine/transport/nodes.h"

#include "engine/geometry/polygon.h"
#include "tests/unit/mesh/sample_scenes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace hanei {
namespace {

const Vec3 up{0.0, 0.0, 1.0};

double cross_height(const Vec3& a, const Vec3& b, const Vec3& p) { return glm::dot(glm::cross(b - a, p - a), up); }

/// A mesh of one patch on the plane z = 0.
Mesh one_patch(const Polygon& outline) {
    Mesh mesh;
    MeshFace face;
    face.face.normal = up;
    face.face.along = {1.0, 0.0, 0.0};
    face.face.region.outline = outline;
    face.patch_count = 1;
    face.vertex_count = static_cast<std::uint32_t>(outline.size());
    mesh.faces.push_back(face);
    Patch patch;
    patch.outline = outline;
    for (std::uint32_t k = 0; k < outline.size(); ++k) {
        patch.corners.push_back(VertexId{k});
        mesh.vertices.push_back({0, {outline[k], up, Vec3{0.0}}, 0.0, {}, {}});
    }
    patch.centre = centroid(outline);
    patch.area = glm::length(vector_area(outline));
    mesh.patches.push_back(patch);
    return mesh;
}

const Polygon rectangle = {{1, 1, 0}, {5, 1, 0}, {5, 3, 0}, {1, 3, 0}};
const Polygon triangle = {{0, 0, 0}, {3, 0.2, 0}, {0.5, 1, 0}};
const Polygon wedge = {{0, 0, 0}, {4, 0, 0}, {4, 0.1, 0}, {2, 0.7, 0}, {0, 1, 0}};

TEST(Nodes, of_constant_elements_are_the_middles_of_the_patches) {
    const auto mesh = make_mesh(sample::computer_room(), 0.8);
    const Nodes nodes = nodes_of(*mesh, Elements::constant);
    ASSERT_EQ(nodes.size(), mesh->patches.size());
    for (std::size_t p = 0; p < nodes.size(); ++p) {
        EXPECT_EQ(nodes.receivers[p], mesh->centre_of(mesh->patches[p]));
        EXPECT_EQ(nodes.areas[p], mesh->patches[p].area);
    }
}

TEST(Nodes, of_a_rectangle_are_the_points_of_gauss) {
    const Nodes nodes = nodes_of(one_patch(rectangle), Elements::linear);
    const double x = 2.0 / std::sqrt(3.0), y = 1.0 / std::sqrt(3.0);
    const Vec3 expected[4] = {{3 - x, 2 - y, 0}, {3 + x, 2 - y, 0}, {3 - x, 2 + y, 0}, {3 + x, 2 + y, 0}};
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_LT(glm::length(nodes.receivers[k].position - expected[k]), 1e-14);
        EXPECT_EQ(nodes.areas[k], 2.0);
    }
}

TEST(Nodes, of_a_square_keep_to_its_edges_however_it_is_turned_and_rounded) {
    for (double turn = 0.0; turn < 6.3; turn += 0.1) {
        const Vec3 e{std::cos(turn), std::sin(turn), 0.0}, f{-std::sin(turn), std::cos(turn), 0.0};
        const Vec3 corner{1000.1, 3.3, 0.0};
        const Nodes nodes = nodes_of(one_patch({corner, corner + e, corner + e + f, corner + f}), Elements::linear);
        for (const Receiver& node : nodes.receivers) {
            const double along = glm::dot(node.position - corner, e);
            EXPECT_NEAR(std::abs(along - 0.5), 0.5 / std::sqrt(3.0), 1e-11);  // coordinates of 1000 m
        }
    }
}

TEST(Nodes, lie_inside_every_patch_of_a_furnished_room) {
    const auto mesh = make_mesh(sample::computer_room(), 0.5);
    const Nodes nodes = nodes_of(*mesh, Elements::linear);
    for (std::size_t p = 0; p < mesh->patches.size(); ++p) {
        const Polygon& outline = mesh->patches[p].outline;
        for (std::size_t n = 4 * p; n < 4 * p + 4; ++n) {
            for (std::size_t k = 0; k < outline.size(); ++k) {
                const Vec3 edge = outline[(k + 1) % outline.size()] - outline[k];
                const Vec3 inside = glm::cross(nodes.receivers[n].normal, edge);
                EXPECT_GT(glm::dot(inside, nodes.receivers[n].position - outline[k]), 0.0);
            }
        }
    }
    for (const Polygon& polygon : {triangle, wedge}) {
        for (const Receiver& node : nodes_of(one_patch(polygon), Elements::linear).receivers) {
            for (std::size_t k = 0; k < polygon.size(); ++k) {
                EXPECT_GT(cross_height(polygon[k], polygon[(k + 1) % polygon.size()], node.position), 0.0);
            }
        }
    }
}

TEST(Nodes, a_patchs_mean_is_the_mean_of_its_nodes_for_any_linear_exitance) {
    for (const Polygon& polygon : {rectangle, triangle, wedge}) {
        const Mesh mesh = one_patch(polygon);
        const Nodes nodes = nodes_of(mesh, Elements::linear);
        const auto exitance = [](const Vec3& place) { return 7.0 + 2.0 * place.x - 1.5 * place.y; };
        std::vector<double> values;
        for (const Receiver& node : nodes.receivers) values.push_back(exitance(node.position));
        EXPECT_NEAR(patch_means(nodes, values)[0], exitance(mesh.patches[0].centre), 1e-13);
        for (const Vec3& corner : polygon) {
            EXPECT_NEAR(exitance_at(mesh, nodes, PatchId{0}, corner, values), exitance(corner), 1e-13);
        }
    }
}

TEST(Nodes, vertices_take_the_mean_of_their_patches_and_never_less_than_nothing) {
    const auto mesh = make_mesh(sample::box_room(4.0, 3.0, 2.5), 1.0);
    const Nodes nodes = nodes_of(*mesh, Elements::linear);
    std::vector<double> values;
    for (const Receiver& node : nodes.receivers) values.push_back(10.0 + node.position.x - 20.0 * node.position.z);
    const std::vector<double> at_vertices = vertex_values(*mesh, nodes, values);
    for (std::size_t k = 0; k < at_vertices.size(); ++k) {
        const Vec3& place = mesh->vertices[k].receiver.position;
        EXPECT_NEAR(at_vertices[k], std::max(0.0, 10.0 + place.x - 20.0 * place.z), 1e-12);
    }
    const Nodes middles = nodes_of(*mesh, Elements::constant);
    const std::vector<double> all_five(middles.size(), 5.0);
    for (const double value : vertex_values(*mesh, middles, all_five)) EXPECT_EQ(value, 5.0);
}

TEST(Quarters, cover_the_patch_and_none_is_empty) {
    for (const Polygon& polygon : {rectangle, triangle, wedge}) {
        const Mesh mesh = one_patch(polygon);
        const Nodes nodes = nodes_of(mesh, Elements::linear);
        double covered = 0.0;
        for (const Polygon& quarter : quarters_of(mesh, nodes, PatchId{0})) {
            const double area = glm::dot(vector_area(quarter), up);
            EXPECT_GT(area, 0.05 * mesh.patches[0].area);
            covered += area;
        }
        EXPECT_NEAR(covered, mesh.patches[0].area, 1e-14);
    }
}

TEST(Quarters, a_linear_quantity_comes_back_from_its_means) {
    for (const Polygon& polygon : {rectangle, triangle, wedge}) {
        const Mesh mesh = one_patch(polygon);
        const Nodes nodes = nodes_of(mesh, Elements::linear);
        const auto light = [](const Vec3& place) { return 30.0 - 2.0 * place.x + 1.5 * place.y; };
        std::array<double, 4> means{};
        const std::array<Polygon, 4> quarters = quarters_of(mesh, nodes, PatchId{0});
        for (std::size_t k = 0; k < 4; ++k) means[k] = light(centroid(quarters[k]));
        const std::array<double, 4> values = node_values_of_quarters(mesh, nodes, PatchId{0}, means);
        for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(values[k], light(nodes.receivers[k].position), 1e-12);
    }
}

TEST(Quarters, light_on_one_quarter_alone_keeps_its_flux_and_goes_nowhere_below_0) {
    for (const Polygon& polygon : {rectangle, triangle, wedge}) {
        const Mesh mesh = one_patch(polygon);
        const Nodes nodes = nodes_of(mesh, Elements::linear);
        const std::array<Polygon, 4> quarters = quarters_of(mesh, nodes, PatchId{0});
        for (std::size_t lit = 0; lit < 4; ++lit) {
            std::array<double, 4> means{};
            means[lit] = 100.0;
            const std::array<double, 4> values = node_values_of_quarters(mesh, nodes, PatchId{0}, means);
            const double flux = 100.0 * glm::length(vector_area(quarters[lit]));
            EXPECT_NEAR(patch_means(nodes, values)[0] * mesh.patches[0].area, flux, 1e-12 * flux);
            for (std::size_t k = 0; k < 4; ++k) {
                EXPECT_GE(values[k], 0.0);
                EXPECT_LE(values[k], values[lit]);
            }
        }
    }
}

}  // namespace
}  // namespace hanei
