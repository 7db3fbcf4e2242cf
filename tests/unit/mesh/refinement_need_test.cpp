#include "engine/mesh/refinement_need.h"

#include "engine/mesh/refine.h"
#include "tests/unit/mesh/sample_scenes.h"
#include "tests/unit/mesh/sound_mesh.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>

namespace hanei {
namespace {

/// A mesh with light given by place.
struct LitMesh {
    std::shared_ptr<const Mesh> mesh;
    std::vector<double> at_vertices, at_patches, reflectance;

    LitMesh(std::shared_ptr<const Mesh> of, const std::function<double(const Vec3&)>& lux) : mesh(std::move(of)) {
        for (const Vertex& vertex : mesh->vertices) at_vertices.push_back(lux(vertex.receiver.position));
        for (const Patch& patch : mesh->patches) at_patches.push_back(lux(patch.centre));
        reflectance.assign(mesh->patches.size(), 0.5);
    }
    MeshLight light() const { return {at_vertices, at_patches, reflectance, {}}; }
};

std::shared_ptr<const Mesh> plain_room() { return make_mesh(sample::box_room(4.0, 3.0, 2.5), 0.5); }

double step(const Vec3& place) { return place.x < 1.7 ? 0.0 : 100.0; }

TEST(RefinementNeed, even_light_needs_no_finer_mesh) {
    const LitMesh room(plain_room(), [](const Vec3&) { return 300.0; });
    const std::vector<double> need = refinement_need(*room.mesh, room.light());
    EXPECT_EQ(*std::max_element(need.begin(), need.end()), 0.0);
    const std::vector<char> split = patches_to_split(*room.mesh, need, 1000);
    EXPECT_EQ(std::count(split.begin(), split.end(), 1), 0);
}

TEST(RefinementNeed, patches_on_a_shadows_border_are_cut_and_no_others) {
    const LitMesh room(plain_room(), step);
    const std::vector<double> need = refinement_need(*room.mesh, room.light());
    const std::vector<char> split = patches_to_split(*room.mesh, need, 1000);
    for (std::size_t p = 0; p < split.size(); ++p) {
        const Polygon& outline = room.mesh->patches[p].outline;
        const auto [low, high] =
            std::minmax_element(outline.begin(), outline.end(), [](const Vec3& a, const Vec3& b) { return a.x < b.x; });
        EXPECT_EQ(split[p] != 0, low->x < 1.7 && high->x > 1.7);
    }
}

TEST(RefinementNeed, the_budget_is_kept_and_the_greatest_need_comes_first) {
    const LitMesh room(plain_room(), [](const Vec3& place) { return 10.0 * place.x * place.x; });
    const std::vector<double> need = refinement_need(*room.mesh, room.light());
    const std::vector<char> split = patches_to_split(*room.mesh, need, 30);
    EXPECT_EQ(refined(*room.mesh, split).mesh->patches.size(), room.mesh->patches.size() + 30);
    double least_cut = std::numeric_limits<double>::infinity();
    double greatest_whole = 0.0;
    for (std::size_t p = 0; p < split.size(); ++p) {
        if (split[p]) least_cut = std::min(least_cut, need[p]);
        if (!split[p]) greatest_whole = std::max(greatest_whole, need[p]);
    }
    EXPECT_GE(least_cut, greatest_whole);
}

TEST(RefinementNeed, rounds_of_refinement_gather_about_a_step_of_light) {
    std::shared_ptr<const Mesh> mesh = plain_room();
    for (int round = 0; round < 4; ++round) {
        const LitMesh room(mesh, step);
        mesh = refined(*mesh, patches_to_split(*mesh, refinement_need(*mesh, room.light()), mesh->patches.size())).mesh;
    }
    double misplaced = 0.0;  // m2 of patches that the step crosses
    for (const Patch& patch : mesh->patches) {
        const auto [low, high] = std::minmax_element(patch.outline.begin(), patch.outline.end(),
                                                     [](const Vec3& a, const Vec3& b) { return a.x < b.x; });
        if (low->x < 1.7 && high->x > 1.7) misplaced += patch.area;
    }
    EXPECT_NEAR(misplaced, (2 * 3.0 + 2 * 2.5) * 0.5 / 16.0, 1e-6);  // a strip of 0.5 m halved four times
    expect_sound(*mesh);
}

TEST(RefinementNeed, what_reflects_nothing_or_is_not_finite_needs_nothing) {
    LitMesh room(plain_room(), step);
    room.reflectance.assign(room.reflectance.size(), 0.0);
    std::vector<double> need = refinement_need(*room.mesh, room.light());
    EXPECT_EQ(*std::max_element(need.begin(), need.end()), 0.0);
    room.reflectance.assign(room.reflectance.size(), 0.5);
    room.at_vertices.assign(room.at_vertices.size(), std::numeric_limits<double>::infinity());
    need = refinement_need(*room.mesh, room.light());
    EXPECT_EQ(*std::max_element(need.begin(), need.end()), 0.0);
}

TEST(RefinementNeed, a_slope_that_linear_elements_follow_needs_no_finer_mesh) {
    const LitMesh room(plain_room(), [](const Vec3& place) { return 50.0 + 20.0 * place.x + 7.0 * place.z; });
    EXPECT_GT(refinement_need(*room.mesh, room.light())[0], 0.0);
    std::vector<double> at_corners;
    for (const Patch& patch : room.mesh->patches) {
        for (const VertexId id : patch.corners) at_corners.push_back(room.at_vertices[static_cast<std::size_t>(id)]);
    }
    MeshLight light = room.light();
    light.of_elements = at_corners;
    std::vector<double> need = refinement_need(*room.mesh, light);
    EXPECT_EQ(*std::max_element(need.begin(), need.end()), 0.0);
    at_corners[5] -= 3.0;  // the second corner of the second patch
    need = refinement_need(*room.mesh, light);
    EXPECT_NEAR(need[1], 0.5 * room.mesh->patches[1].area * 3.0, 1e-12);
    EXPECT_EQ(std::count_if(need.begin(), need.end(), [](double n) { return n > 0.0; }), 1);
}

TEST(RefinementNeed, importance_takes_the_place_of_area) {
    LitMesh room(plain_room(), step);
    std::vector<double> importance(room.mesh->patches.size(), 0.0);
    importance[3] = 1.0;
    MeshLight light = room.light();
    light.importance = importance;
    const std::vector<double> need = refinement_need(*room.mesh, light);
    EXPECT_EQ(need[3], 0.5 * 100.0);
    EXPECT_EQ(std::count_if(need.begin(), need.end(), [](double n) { return n > 0.0; }), 1);
}

}  // namespace
}  // namespace hanei
