#include "engine/transport/factors.h"

#include "engine/geometry/visible_part.h"
#include "engine/transport/paper_rows.h"
#include "tests/unit/mesh/sample_scenes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace hanei {
namespace {

std::vector<Receiver> centres_of(const Mesh& mesh) {
    std::vector<Receiver> centres;
    for (const Patch& patch : mesh.patches) centres.push_back(mesh.centre_of(patch));
    return centres;
}

struct Rows {
    std::shared_ptr<const Mesh> mesh;
    DenseRows factors;
    Visibility visibility;

    Rows(const Scene& scene, double max_patch, int threads = 2)
        : Rows(scene, make_mesh(scene, max_patch), threads, {}) {}
    Rows(const Scene& scene, std::shared_ptr<const Mesh> of, int threads, std::vector<Receiver> receivers)
        : mesh(std::move(of)) {
        if (receivers.empty()) receivers = centres_of(*mesh);
        factors = *patch_factors(*mesh, receivers, {threads});
        visibility = *patch_visibility(*mesh, receivers, occluders_of(scene), {threads});
    }
    double visible(std::size_t row, std::size_t column) const {
        const double factor = static_cast<double>(factors.row(row)[column]);
        return visibility.all_visible ? factor : factor * static_cast<double>(visibility.share.row(row)[column]);
    }
    double sum(std::size_t row) const {
        double total = 0.0;
        for (std::size_t k = 0; k < factors.columns; ++k) total += visible(row, k);
        return total;
    }
};

// Floats round each of a thousand factors by 6e-8 of it; what is cut away and dropped is 1e-9 wide.
constexpr double closed = 1e-6;

void expect_closed(const Rows& rows) {
    for (std::size_t k = 0; k < rows.factors.rows; ++k) EXPECT_NEAR(rows.sum(k), 1.0, closed) << "row " << k;
}

TEST(Factors, rows_of_an_empty_room_sum_to_1_and_everything_is_visible) {
    const Rows rows(sample::box_room(6.0, 4.0, 2.8), 0.5);
    EXPECT_TRUE(rows.visibility.all_visible);
    expect_closed(rows);
}

TEST(Factors, rows_of_an_l_shaped_room_sum_to_1_past_its_re_entrant_walls) {
    const Rows rows(sample::l_room(), 0.4);
    EXPECT_FALSE(rows.visibility.all_visible);
    expect_closed(rows);
}

TEST(Factors, rows_of_a_furnished_room_sum_to_1_in_gaps_and_under_tables) {
    expect_closed({sample::computer_room(), 0.5});
}

TEST(Factors, rows_sum_to_1_when_the_furniture_is_made_of_free_surfaces) {
    Scene scene = sample::box_room(4.0, 3.0, 2.5);
    sample::add_box_of_surfaces(scene, {1.0, 1.0, 0.0}, {1.05, 1.7, 0.69}, sample::sides_only);
    sample::add_box_of_surfaces(scene, {0.9, 0.9, 0.69}, {2.0, 1.8, 0.72}, sample::closed_box);
    sample::add_box_of_surfaces(scene, {1.2, 1.2, 0.72}, {1.6, 1.6, 1.1}, sample::without_bottom);
    sample::add_box_of_surfaces(scene, {3.0, 2.0, 0.0}, {3.5, 2.5, 1.1}, sample::without_bottom);
    expect_closed({scene, 0.4});
}

TEST(Factors, rows_sum_to_1_from_vertices_on_the_edges_of_their_faces) {
    Scene scene = sample::box_room(4.0, 3.0, 2.5);
    sample::add_box(scene, {2.0, 1.3, 0.0}, {1.0, 0.8, 1.0});
    const auto mesh = make_mesh(scene, 0.5);
    std::vector<Receiver> receivers;
    for (const Vertex& vertex : mesh->vertices) receivers.push_back(vertex.receiver);
    expect_closed(Rows(scene, mesh, 2, receivers));
}

TEST(Factors, each_is_the_configuration_factor_of_its_patch_and_0_within_a_face) {
    const Rows rows(sample::computer_room(), 0.8);
    for (std::size_t i = 0; i < rows.mesh->patches.size(); i += 5) {
        const Patch& at = rows.mesh->patches[i];
        const Receiver receiver = rows.mesh->centre_of(at);
        for (std::size_t j = 0; j < rows.mesh->patches.size(); ++j) {
            const Patch& patch = rows.mesh->patches[j];
            const double expected = at.face == patch.face ? 0.0 : configuration_factor(patch.outline, receiver);
            EXPECT_NEAR(static_cast<double>(rows.factors.row(i)[j]), expected, 1e-7 * expected + 1e-13);  // float
        }
    }
}

TEST(Factors, shares_are_those_of_the_visible_part_past_all_bodies) {
    const Scene scene = sample::computer_room();
    const Rows rows(scene, 0.8);
    const OccluderSet occluders = occluders_of(scene);
    std::vector<BodyIndex> all(occluders.bodies().size());
    for (BodyIndex k = 0; k < all.size(); ++k) all[k] = k;
    for (std::size_t i = 0; i < rows.mesh->patches.size(); i += 11) {
        const Receiver receiver = rows.mesh->centre_of(rows.mesh->patches[i]);
        for (std::size_t j = 0; j < rows.mesh->patches.size(); ++j) {
            if (rows.factors.row(i)[j] <= 0.0F) continue;
            const double exact = visible_configuration_factor(rows.mesh->patches[j].outline, receiver, occluders, all);
            // what FlatView::weight holds of patches that are small against their distance
            EXPECT_NEAR(rows.visible(i, j), exact, 3e-5 * static_cast<double>(rows.factors.row(i)[j]) + 1e-9);
        }
    }
}

TEST(Factors, the_same_bits_on_one_thread_on_two_and_on_seven) {
    const Scene scene = sample::computer_room();
    const Rows one(scene, 0.8, 1);
    for (const int threads : {2, 7}) {
        const Rows many(scene, 0.8, threads);
        EXPECT_EQ(one.factors.values, many.factors.values);
        EXPECT_EQ(one.visibility.share.values, many.visibility.share.values);
    }
}

TEST(Factors, a_stopped_computation_returns_nothing) {
    const Scene scene = sample::computer_room();
    const auto mesh = make_mesh(scene, 0.8);
    std::stop_source stop;
    stop.request_stop();
    const Work work{1, stop.get_token(), nullptr};
    EXPECT_FALSE(patch_factors(*mesh, centres_of(*mesh), work));
    EXPECT_FALSE(patch_visibility(*mesh, centres_of(*mesh), occluders_of(scene), work));
}

/// All rows of the paper's method.
struct WholePaper {
    std::size_t count;
    std::vector<float> factors, visible;
    bool any_hidden;

    WholePaper(const Mesh& mesh, const OccluderSet* occluders)
        : count(mesh.vertices.size()), factors(count * count, 0.0F), visible(count * count, 1.0F) {
        any_hidden = PaperRows(mesh, occluders).write(0, count, factors.data(), visible.data());
    }
};

TEST(PaperFactors, follow_equation_4) {
    const auto mesh = make_mesh(sample::box_room(4.0, 3.0, 2.0), 1.0);
    const WholePaper rows(*mesh, nullptr);
    for (std::size_t i = 0; i < mesh->vertices.size(); ++i) {
        const Receiver& at = mesh->vertices[i].receiver;
        for (std::size_t j = 0; j < mesh->vertices.size(); ++j) {
            const Vertex& from = mesh->vertices[j];
            const Vec3 apart = from.receiver.position - at.position;
            const double r = glm::length(apart);
            double expected = 0.0;
            if (r > 0.0 && glm::dot(apart, at.normal) > 0.0 && glm::dot(apart, from.receiver.normal) < 0.0) {
                expected = glm::dot(apart / r, at.normal) * -glm::dot(apart / r, from.receiver.normal) * from.area /
                           (3.14159265358979323846 * r * r);
            }
            EXPECT_NEAR(static_cast<double>(rows.factors[i * rows.count + j]), expected, 1e-6 * expected);  // float
        }
    }
}

TEST(PaperFactors, a_vertex_weighs_a_quarter_a_half_or_a_whole_patch) {
    const auto mesh = make_mesh(sample::box_room(4.0, 3.0, 2.0), 1.0);
    const MeshFace& floor = mesh->faces[0];
    double sum = 0.0;
    for (std::uint32_t k = 0; k < floor.vertex_count; ++k) {
        const Vertex& vertex = mesh->vertices[floor.first_vertex + k];
        const bool on_x = vertex.receiver.position.x < 1e-9 || vertex.receiver.position.x > 4.0 - 1e-9;
        const bool on_y = vertex.receiver.position.y < 1e-9 || vertex.receiver.position.y > 3.0 - 1e-9;
        EXPECT_NEAR(vertex.area, on_x && on_y ? 0.25 : on_x || on_y ? 0.5 : 1.0, 1e-12);
        sum += vertex.area;
    }
    EXPECT_NEAR(sum, 12.0, 1e-12);
}

TEST(PaperVisibility, agrees_with_every_single_sight_line) {
    const Scene scene = sample::computer_room();
    const auto mesh = make_mesh(scene, 0.8);
    const OccluderSet occluders = occluders_of(scene);
    const WholePaper rows(*mesh, &occluders);
    ASSERT_TRUE(rows.any_hidden);
    std::size_t hidden = 0;
    for (std::size_t i = 0; i < mesh->vertices.size(); i += 3) {
        for (std::size_t j = 0; j < mesh->vertices.size(); ++j) {
            if (rows.factors[i * rows.count + j] <= 1e-12F) continue;  // in the plane of either face but for rounding
            const bool blocked =
                occluders.blocks(mesh->vertices[i].receiver.position, mesh->vertices[j].receiver.position);
            EXPECT_EQ(rows.visible[i * rows.count + j], blocked ? 0.0F : 1.0F) << i << " to " << j;
            if (blocked) ++hidden;
        }
    }
    EXPECT_GT(hidden, 1000U);
}

TEST(PaperVisibility, an_empty_room_is_all_visible) {
    const Scene scene = sample::box_room(4.0, 3.0, 2.0);
    const OccluderSet occluders = occluders_of(scene);
    EXPECT_FALSE(WholePaper(*make_mesh(scene, 1.0), &occluders).any_hidden);
}

}  // namespace
}  // namespace hanei
