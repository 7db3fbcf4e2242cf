#include "engine/transport/factor_rows.h"

#include "engine/transport/factors.h"
#include "tests/unit/mesh/sample_scenes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace hanei {
namespace {

struct Rows {
    std::shared_ptr<const Mesh> mesh;
    Nodes nodes;
    std::size_t columns = 0;
    std::vector<float> values;

    Rows(const Scene& scene, double max_patch, Elements elements, std::vector<Receiver> receivers = {})
        : mesh(make_mesh(scene, max_patch)), nodes(nodes_of(*mesh, elements)) {
        if (receivers.empty()) receivers = nodes.receivers;
        FactorRows rows(*mesh, nodes);
        columns = rows.columns();
        values.resize(receivers.size() * columns);
        rows.write(receivers, values.data());
    }
    double at(std::size_t row, std::size_t column) const { return static_cast<double>(values[row * columns + column]); }
    double sum(std::size_t row) const {
        double total = 0.0;
        for (std::size_t k = 0; k < columns; ++k) total += at(row, k);
        return total;
    }
};

/// Integral of the kernel times the basis of each node, by midpoints on a grid; the middle kept between
/// the nodes.
std::array<double, 4> shares_by_force(const Mesh& mesh, const Nodes& nodes, std::size_t patch, const Receiver& at) {
    const Polygon& outline = mesh.patches[patch].outline;
    const bool smooth = is_above_horizon(outline, at) && glm::length(at.position - outline[0]) > 1.0;
    const int steps = smooth ? 50 : 400;
    const PatchFrame frame = nodes.frame(patch);
    const Vec3& front = mesh.faces[mesh.patches[patch].face].face.normal;
    std::array<double, 4> sums{};
    for (int i = 0; i < steps; ++i) {
        for (int j = 0; j < steps; ++j) {
            const double u = (i + 0.5) / steps, v = (j + 0.5) / steps;
            const Vec3 place = outline[0] + u * (outline[1] - outline[0]) + v * (outline[3] - outline[0]);
            const Vec3 seen = place - at.position;
            const double square = glm::dot(seen, seen);
            const double kernel = std::max(0.0, glm::dot(seen, at.normal)) * std::max(0.0, -glm::dot(seen, front)) /
                                  (std::numbers::pi * square * square);
            const Vec2 c = frame.coordinates(place);
            for (unsigned k = 0; k < 4; ++k) {
                const double x = k & 1U ? c.x : -c.x, y = k & 2U ? c.y : -c.y;
                sums[k] += 0.25 * (1.0 + x) * (1.0 + y) * kernel * mesh.patches[patch].area / (steps * steps);
            }
        }
    }
    const auto& [a, b, c, d] = sums;
    const double factor = a + b + c + d;
    if (!(factor > 0.0)) return {};
    return node_shares({factor, {(b + d - a - c) / factor, (c + d - a - b) / factor}, (a + d - b - c) / factor});
}

// Errors of single coefficients have either sign.
constexpr double closed = 3e-6;
// Where the horizon only just leaves a patch, what points leave out is a greater part of what is seen.
constexpr double of_a_factor = 2e-4;

TEST(FactorRows, of_constant_elements_are_the_form_factors_of_the_patches) {
    const Rows rows(sample::computer_room(), 0.5, Elements::constant);
    const DenseRows expected = *patch_factors(*rows.mesh, rows.nodes.receivers, {2});
    for (std::size_t k = 0; k < expected.values.size(); ++k) {
        const double factor = static_cast<double>(expected.values[k]);
        EXPECT_NEAR(static_cast<double>(rows.values[k]), factor, of_a_factor * factor + 1e-9);
    }
}

TEST(FactorRows, of_linear_elements_add_up_to_the_form_factors_and_are_never_below_0) {
    const Rows rows(sample::computer_room(), 0.9, Elements::linear);
    const DenseRows expected = *patch_factors(*rows.mesh, rows.nodes.receivers, {2});
    for (std::size_t i = 0; i < expected.rows; ++i) {
        for (std::size_t p = 0; p < expected.columns; ++p) {
            double sum = 0.0;
            for (std::size_t k = 4 * p; k < 4 * p + 4; ++k) {
                EXPECT_GE(rows.at(i, k), 0.0);
                sum += rows.at(i, k);
            }
            const auto factor = static_cast<double>(expected.row(i)[p]);
            EXPECT_NEAR(sum, factor, of_a_factor * factor + 1e-9);
        }
    }
}

TEST(FactorRows, of_a_closed_room_sum_to_1) {
    for (const Elements elements : {Elements::constant, Elements::linear}) {
        for (const double max_patch : {1.0, 0.5}) {
            const Rows rows(sample::box_room(6.0, 4.0, 2.8), max_patch, elements);
            for (std::size_t k = 0; k < rows.nodes.size(); ++k) EXPECT_NEAR(rows.sum(k), 1.0, closed);
        }
    }
}

TEST(FactorRows, sum_to_1_for_receivers_on_edges_in_corners_and_across_the_horizon) {
    const Scene scene = sample::box_room(4.0, 3.0, 2.5);
    std::vector<Receiver> receivers;
    const auto mesh = make_mesh(scene, 0.5);
    for (const Vertex& vertex : mesh->vertices) receivers.push_back(vertex.receiver);
    for (const double height : {1e-7, 1e-4, 0.01, 0.8}) {
        receivers.push_back({{1.0, 1.1, height}, {0.0, 0.0, 1.0}, Vec3{0.0}});
        receivers.push_back({{1.0, 1.1, height}, {0.0, 0.0, -1.0}, Vec3{0.0}});
        receivers.push_back({{1.0, 1.1, height}, {0.6, 0.0, 0.8}, Vec3{0.0}});
        receivers.push_back({{1.0, 1.1, height}, {1.0, 0.0, 0.0}, Vec3{0.0}});
    }
    for (const Elements elements : {Elements::constant, Elements::linear}) {
        const Rows rows(scene, 0.5, elements, receivers);
        for (std::size_t k = 0; k < receivers.size(); ++k) EXPECT_NEAR(rows.sum(k), 1.0, closed) << "receiver " << k;
    }
}

TEST(FactorRows, of_linear_elements_are_the_kernel_integrated_with_the_basis) {
    const Rows rows(sample::box_room(4.0, 3.0, 2.5), 0.5, Elements::linear);
    for (std::size_t i = 0; i < rows.nodes.size(); i += 97) {
        for (std::size_t p = 0; p < rows.mesh->patches.size(); p += 3) {
            const std::array<double, 4> exact = shares_by_force(*rows.mesh, rows.nodes, p, rows.nodes.receivers[i]);
            const double factor = exact[0] + exact[1] + exact[2] + exact[3];
            const double allowed = 1e-3;  // what four points leave out of the middle
            for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(rows.at(i, 4 * p + k), exact[k], allowed * factor + 1e-9);
        }
    }
}

TEST(FactorRows, of_patches_that_the_horizon_cuts_are_those_of_what_is_above_it) {
    std::vector<Receiver> receivers;
    for (const Vec3& normal : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{1, 0, 0}, glm::normalize(Vec3{0.5, -0.2, 0.6})}) {
        receivers.push_back({{1.7, 1.3, 0.85}, normal, Vec3{0.0}});
    }
    const Rows rows(sample::box_room(4.0, 3.0, 2.5), 0.5, Elements::linear, receivers);
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        for (std::size_t p = 0; p < rows.mesh->patches.size(); ++p) {
            const Polygon& outline = rows.mesh->patches[p].outline;
            if (is_above_horizon(outline, receivers[i])) continue;
            const std::array<double, 4> exact = shares_by_force(*rows.mesh, rows.nodes, p, receivers[i]);
            const double factor = exact[0] + exact[1] + exact[2] + exact[3];
            // far away the parts that a slanting horizon leaves are not rectangles: four points leave out their skew
            const double allowed = i == 3 ? 2e-2 : 3e-3;
            for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(rows.at(i, 4 * p + k), exact[k], allowed * factor + 1e-9);
        }
    }
}

TEST(FactorRows, are_the_same_in_a_room_of_millimetres_and_in_one_of_kilometres) {
    const Rows rows(sample::box_room(6.0, 4.0, 3.0), 1.0, Elements::linear);
    for (const double scale : {1e-3, 1e3}) {
        const Rows scaled(sample::box_room(6.0 * scale, 4.0 * scale, 3.0 * scale), scale, Elements::linear);
        ASSERT_EQ(scaled.values.size(), rows.values.size());
        for (std::size_t k = 0; k < rows.values.size(); ++k) {
            // single precision, and squares integrated along either side
            EXPECT_NEAR(scaled.values[k], rows.values[k], 3e-5F * rows.values[k] + 1e-12F);
        }
    }
}

TEST(FactorRows, are_finite_for_receivers_in_the_planes_of_faces_and_on_their_edges) {
    const Scene scene = sample::computer_room();
    std::vector<Receiver> receivers;
    const auto mesh = make_mesh(scene, 1.0);
    for (const Vertex& vertex : mesh->vertices) {
        receivers.push_back(vertex.receiver);
        receivers.push_back({vertex.receiver.position, -vertex.receiver.normal, Vec3{0.0}});
        receivers.push_back(
            {vertex.receiver.position + 1e-7 * vertex.receiver.normal, vertex.receiver.normal, Vec3{0.0}});
        receivers.push_back({vertex.receiver.position, glm::normalize(Vec3{0.3, -0.5, 0.8}), Vec3{0.0}});
    }
    for (const Elements elements : {Elements::constant, Elements::linear}) {
        const Rows rows(scene, 1.0, elements, receivers);
        for (const float value : rows.values) ASSERT_TRUE(value >= 0.0F && value <= 1.0F + 1e-5F) << value;
    }
}

TEST(FactorRows, a_row_has_the_same_bits_alone_and_beside_others) {
    const Rows all(sample::computer_room(), 0.9, Elements::linear);
    for (std::size_t i = 0; i < all.nodes.size(); i += 61) {
        FactorRows alone(*all.mesh, all.nodes);
        std::vector<float> row(alone.columns());
        alone.write(std::span(all.nodes.receivers).subspan(i, 1), row.data());
        EXPECT_TRUE(
            std::equal(row.begin(), row.end(), all.values.begin() + static_cast<std::ptrdiff_t>(i * all.columns)));
    }
}

}  // namespace
}  // namespace hanei
