#include "engine/mesh/refine.h"

#include "engine/geometry/polygon.h"
#include "engine/mesh/free_sector.h"
#include "tests/unit/mesh/sample_scenes.h"
#include "tests/unit/mesh/sound_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace hanei {
namespace {

constexpr Vec3 along{1.0, 0.0, 0.0};
constexpr Vec3 across{0.0, 1.0, 0.0};

std::vector<char> all_of(const Mesh& mesh) { return std::vector<char>(mesh.patches.size(), 1); }

/// Every third patch, shifted by `round`: neighbours cut unequally.
std::vector<char> some_of(const Mesh& mesh, std::size_t round) {
    std::vector<char> split(mesh.patches.size(), 0);
    for (std::size_t p = round; p < split.size(); p += 3) split[p] = 1;
    return split;
}

TEST(Refine, nothing_to_split_leaves_the_mesh_as_it_is) {
    const auto coarse = make_mesh(sample::computer_room(), 0.5);
    const RefinedMesh fine = refined(*coarse, std::vector<char>(coarse->patches.size(), 0));
    ASSERT_EQ(fine.mesh->patches.size(), coarse->patches.size());
    ASSERT_EQ(fine.mesh->vertices.size(), coarse->vertices.size());
    for (std::size_t p = 0; p < coarse->patches.size(); ++p) {
        EXPECT_EQ(static_cast<std::size_t>(fine.origin[p]), p);
        EXPECT_EQ(fine.mesh->patches[p].corners, coarse->patches[p].corners);
        EXPECT_EQ(fine.mesh->patches[p].centre, coarse->patches[p].centre);
        EXPECT_EQ(fine.mesh->patches[p].material, coarse->patches[p].material);
    }
    for (std::size_t k = 0; k < coarse->vertices.size(); ++k) {
        EXPECT_EQ(fine.mesh->vertices[k].receiver, coarse->vertices[k].receiver);
        EXPECT_EQ(fine.mesh->vertices[k].area, coarse->vertices[k].area);
        EXPECT_EQ(fine.mesh->vertices[k].material, coarse->vertices[k].material);
    }
}

TEST(Refine, a_grid_of_which_all_is_split_is_the_grid_of_half_the_width) {
    const Scene scene = sample::box_room(4.0, 3.0, 2.5);
    const auto coarse = make_mesh(scene, 0.5);
    const auto half = make_mesh(scene, 0.25);
    const RefinedMesh fine = refined(*coarse, all_of(*coarse));
    EXPECT_EQ(fine.mesh->patches.size(), half->patches.size());
    ASSERT_EQ(fine.mesh->vertices.size(), half->vertices.size());
    const auto places = [](const Mesh& mesh) {
        std::vector<std::array<long, 9>> found;  // um: grids of 0.25 m
        for (const Vertex& v : mesh.vertices) {
            std::array<long, 9> key{};
            for (int c = 0; c < 3; ++c) {
                const auto k = static_cast<std::size_t>(c);
                key[k] = std::lround(1e6 * v.receiver.position[c]);
                key[k + 3] = std::lround(1e6 * v.receiver.normal[c]);
                key[k + 6] = std::lround(1e6 * v.receiver.inward[c]);
            }
            found.push_back(key);
        }
        std::sort(found.begin(), found.end());
        return found;
    };
    EXPECT_EQ(places(*fine.mesh), places(*half));
    expect_sound(*fine.mesh);
}

TEST(Refine, a_furnished_room_stays_sound_and_keeps_the_area_of_every_patch) {
    std::shared_ptr<const Mesh> mesh = make_mesh(sample::computer_room(), 0.6, Grading::crowded);
    for (std::size_t round = 0; round < 3; ++round) {
        const RefinedMesh fine = refined(*mesh, some_of(*mesh, round));
        expect_sound(*fine.mesh);
        ASSERT_EQ(fine.origin.size(), fine.mesh->patches.size());
        std::vector<double> area(mesh->patches.size(), 0.0);
        for (std::size_t p = 0; p < fine.origin.size(); ++p) {
            const Patch& whole = (*mesh)[fine.origin[p]];
            EXPECT_EQ(fine.mesh->patches[p].face, whole.face);
            EXPECT_EQ(fine.mesh->patches[p].material, whole.material);
            area[static_cast<std::size_t>(fine.origin[p])] += fine.mesh->patches[p].area;
        }
        EXPECT_TRUE(std::is_sorted(fine.origin.begin(), fine.origin.end()));
        for (std::size_t p = 0; p < area.size(); ++p) EXPECT_NEAR(area[p], mesh->patches[p].area, rounding);
        mesh = fine.mesh;
    }
}

TEST(Refine, every_vertex_on_a_border_looks_into_its_patches) {
    const auto coarse = make_mesh(sample::computer_room(), 0.6);
    const RefinedMesh fine = refined(*coarse, some_of(*coarse, 1));
    const double near = 4e-9 * diameter_of(*fine.mesh);
    for (const MeshFace& face : fine.mesh->faces) {
        const SectorFinder sectors(*fine.mesh, face);
        for (std::uint32_t k = 0; k < face.vertex_count; ++k) {
            const Receiver& r = fine.mesh->vertices[face.first_vertex + k].receiver;
            const FreeSector sector = free_sector(*fine.mesh, face, r.position, near);
            const FreeSector found = sectors.at(r.position, near);
            EXPECT_EQ(found.angle, sector.angle);
            EXPECT_EQ(found.inward, sector.inward);
            EXPECT_NEAR(glm::length(r.inward - sector.inward), 0.0, 1e-6);  // sums of other sectors, rounded
        }
    }
}

TEST(Refine, given_parts_become_patches_in_their_order) {
    const auto coarse = make_mesh(sample::computer_room(), 0.6);
    const RefinedMesh fine = in_parts(*coarse, [&](PatchId id) -> std::vector<Polygon> {
        const Polygon& outline = (*coarse)[id].outline;  // a fan of triangles, the last of them first
        std::vector<Polygon> fan;
        for (std::size_t k = outline.size() - 2; k > 0; --k) fan.push_back({outline[0], outline[k], outline[k + 1]});
        return fan;
    });
    expect_sound(*fine.mesh);
    std::size_t next = 0;
    for (std::size_t p = 0; p < coarse->patches.size(); ++p) {
        const Polygon& outline = coarse->patches[p].outline;
        for (std::size_t k = outline.size() - 2; k > 0; --k, ++next) {
            ASSERT_LT(next, fine.origin.size());
            EXPECT_EQ(static_cast<std::size_t>(fine.origin[next]), p);
            EXPECT_EQ(fine.mesh->patches[next].outline, (Polygon{outline[0], outline[k], outline[k + 1]}));
        }
    }
    EXPECT_EQ(next, fine.mesh->patches.size());
}

TEST(Refine, a_part_too_thin_to_be_a_patch_is_stood_for_by_the_whole) {
    const auto coarse = make_mesh(sample::box_room(4.0, 3.0, 2.5), 5.0);
    const RefinedMesh fine = in_parts(*coarse, [&](PatchId id) -> std::vector<Polygon> {
        const Polygon& outline = (*coarse)[id].outline;
        return {outline, {outline[0], outline[1], outline[0]}};
    });
    ASSERT_EQ(fine.mesh->patches.size(), 2 * coarse->patches.size());
    EXPECT_EQ(fine.mesh->patches[1].outline, coarse->patches[0].outline);
}

TEST(Refine, a_long_patch_is_cut_across_its_length_only) {
    const Polygon desk_edge{{0, 0, 0}, {1.8, 0, 0}, {1.8, 0.03, 0}, {0, 0.03, 0}};
    const std::vector<Polygon> parts = parts_of(desk_edge, along, across, 1e-9);
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_NEAR(unit_normal(parts[0]).z, 1.0, 1e-15);
    EXPECT_NEAR(diameter(parts[0]), std::hypot(0.9, 0.03), 1e-12);
    EXPECT_EQ(parts_of(desk_edge, across, along, 1e-9).size(), 2U);
    const Polygon two_squares{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
    EXPECT_EQ(parts_of(two_squares, along, across, 1e-9).size(), 2U);
    const Polygon square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    EXPECT_EQ(parts_of(square, along, across, 1e-9).size(), 4U);
}

TEST(Refine, a_patch_as_thin_as_a_tolerance_stays_whole) {
    const Polygon thread{{0, 0, 0}, {1e-8, 0, 0}, {1e-8, 3e-9, 0}, {0, 3e-9, 0}};
    EXPECT_EQ(parts_of(thread, along, across, 1e-9).size(), 1U);
}

TEST(Refine, parts_of_any_convex_polygon_are_convex_and_none_is_a_sliver) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int trial = 0; trial < 2000; ++trial) {
        const std::size_t corners = 3 + random() % 5;
        std::vector<double> angles(corners);
        for (double& angle : angles) angle = 2.0 * std::numbers::pi * share(random);
        std::sort(angles.begin(), angles.end());
        const double length = std::pow(10.0, 2.0 * share(random));
        const double turn = std::numbers::pi * share(random);
        Polygon patch;
        for (const double angle : angles) {
            const double u = length * std::cos(angle);
            const double v = std::sin(angle);
            patch.emplace_back(u * std::cos(turn) - v * std::sin(turn), u * std::sin(turn) + v * std::cos(turn), 0.0);
        }
        const double whole = vector_area(patch).z;
        if (whole < 1e-3) continue;
        double sum = 0.0;
        for (const Polygon& part : parts_of(patch, along, across, 1e-9)) {
            EXPECT_TRUE(is_convex(part, Vec3(0.0, 0.0, 1.0)));
            sum += vector_area(part).z;
            EXPECT_GE(vector_area(part).z, whole / 64.0);  // an eighth of an eighth
        }
        EXPECT_NEAR(sum, whole, 1e-7 * length);
    }
}

}  // namespace
}  // namespace hanei
