#include "engine/transport/closure.h"

#include "engine/transport/factor_rows.h"
#include "engine/transport/paper_rows.h"
#include "engine/transport/visible_shares.h"
#include "tests/unit/mesh/sample_scenes.h"

#include <cmath>
#include <gtest/gtest.h>

namespace hanei {
namespace {

/// The paper's rows of a scene, and what each grid point sees of the patches.
struct PaperRoom {
    std::size_t count = 0;
    std::vector<float> factors, shares;
    std::vector<double> seen;

    explicit PaperRoom(const Scene& scene) {
        const auto mesh = make_mesh(scene, 0.6);
        const OccluderSet occluders = occluders_of(scene);
        const Nodes nodes = nodes_of(*mesh, Elements::constant);
        count = mesh->vertices.size();
        factors.resize(count * count);
        shares.assign(count * count, 1.0F);
        PaperRows(*mesh, &occluders).write(0, count, factors.data(), shares.data());
        FactorRows patches(*mesh, nodes);
        VisibleShares visible(*mesh, occluders);
        for (const Vertex& vertex : mesh->vertices) {
            std::vector<float> of_patches(nodes.size()), parts(nodes.size(), 1.0F);
            patches.write({&vertex.receiver, 1}, of_patches.data());
            visible.write({&vertex.receiver, 1}, parts.data());
            seen.push_back(visible_sum(of_patches, parts));
        }
    }
    std::span<float> row(std::size_t k) { return {factors.data() + k * count, count}; }
    std::span<const float> shares_of(std::size_t k) const { return {shares.data() + k * count, count}; }
};

TEST(Closure, rows_of_the_paper_sum_to_1_in_a_closed_room_after_and_not_before) {
    PaperRoom room(sample::computer_room());
    double worst = 0.0;
    for (std::size_t k = 0; k < room.count; ++k)
        worst = std::max(worst, std::abs(visible_sum(room.row(k), room.shares_of(k)) - 1.0));
    EXPECT_GT(worst, 0.5);
    for (std::size_t k = 0; k < room.count; ++k) {
        EXPECT_NEAR(room.seen[k], 1.0, 1e-5);
        close_row(room.row(k), room.shares_of(k), room.seen[k]);
        EXPECT_NEAR(visible_sum(room.row(k), room.shares_of(k)), room.seen[k], 1e-5);  // floats, a thousand of them
    }
}

TEST(Closure, a_room_without_a_ceiling_keeps_what_escapes) {
    Scene scene;
    sample::add_surface(scene, {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}});
    sample::add_surface(scene, {{0, 0, 0}, {0, 0, 2}, {4, 0, 2}, {4, 0, 0}});
    PaperRoom room(scene);
    for (std::size_t k = 0; k < room.count; ++k) {
        close_row(room.row(k), room.shares_of(k), room.seen[k]);
        EXPECT_LT(room.seen[k], 0.51);
        const double sum = visible_sum(room.row(k), room.shares_of(k));
        EXPECT_NEAR(sum, sum > 0.0 ? room.seen[k] : 0.0, 1e-5);
    }
}

TEST(Closure, a_row_that_sees_no_grid_point_stays_empty) {
    std::vector<float> row{0.0F, 0.0F};
    const std::vector<float> shares{1.0F, 1.0F};
    close_row(row, shares, 1.0);
    EXPECT_EQ(row, (std::vector<float>{0.0F, 0.0F}));
    std::vector<float> hidden{1.0F, 3.0F};
    close_row(hidden, std::vector<float>{0.0F, 0.0F}, 0.0);
    EXPECT_EQ(hidden, (std::vector<float>{1.0F, 3.0F}));
}

}  // namespace
}  // namespace hanei
