#include "engine/transport/closure.h"

#include "tests/unit/mesh/sample_scenes.h"

#include <cmath>
#include <gtest/gtest.h>

namespace hanei {
namespace {

struct PaperRoom {
    std::shared_ptr<const Mesh> mesh;
    std::vector<Receiver> receivers;
    DenseRows factors;
    Visibility visibility;
    std::vector<double> sums;

    explicit PaperRoom(const Scene& scene) : mesh(make_mesh(scene, 0.6)) {
        const OccluderSet occluders = occluders_of(scene);
        for (const Vertex& vertex : mesh->vertices) receivers.push_back(vertex.receiver);
        factors = *paper_factors(*mesh, {2});
        visibility = *paper_visibility(*mesh, occluders, {2});
        sums = *seen_sums(*mesh, receivers, occluders, {2});
    }
    double sum(std::size_t k) const {
        double total = 0.0;
        for (std::size_t j = 0; j < factors.columns; ++j) {
            const double share = visibility.all_visible ? 1.0 : static_cast<double>(visibility.share.row(k)[j]);
            total += static_cast<double>(factors.row(k)[j]) * share;
        }
        return total;
    }
};

TEST(Closure, rows_of_the_paper_sum_to_1_in_a_closed_room_after_and_not_before) {
    PaperRoom room(sample::computer_room());
    double worst = 0.0;
    for (std::size_t k = 0; k < room.receivers.size(); ++k) worst = std::max(worst, std::abs(room.sum(k) - 1.0));
    EXPECT_GT(worst, 0.5);
    close_rows(room.factors, room.visibility, room.sums);
    for (std::size_t k = 0; k < room.receivers.size(); ++k) {
        EXPECT_NEAR(room.sums[k], 1.0, 1e-6);
        EXPECT_NEAR(room.sum(k), room.sums[k], 1e-5);  // floats, a thousand of them
    }
}

TEST(Closure, a_room_without_a_ceiling_keeps_what_escapes) {
    Scene scene;
    sample::add_surface(scene, {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}});
    sample::add_surface(scene, {{0, 0, 0}, {0, 0, 2}, {4, 0, 2}, {4, 0, 0}});
    PaperRoom room(scene);
    close_rows(room.factors, room.visibility, room.sums);
    for (std::size_t k = 0; k < room.receivers.size(); ++k) {
        EXPECT_LT(room.sums[k], 0.51);
        const double expected = room.sum(k) > 0.0 ? room.sums[k] : 0.0;
        EXPECT_NEAR(room.sum(k), expected, 1e-5);
    }
}

TEST(Closure, a_row_that_sees_no_grid_point_stays_empty) {
    DenseRows factors{2, 2, {0.0F, 0.0F, 1.0F, 3.0F}};
    close_rows(factors, Visibility{}, std::vector<double>{1.0, 1.0});
    EXPECT_EQ(factors.values, (std::vector<float>{0.0F, 0.0F, 0.25F, 0.75F}));
}

TEST(Closure, a_stopped_computation_returns_nothing) {
    std::stop_source stop;
    stop.request_stop();
    const auto mesh = make_mesh(sample::box_room(4.0, 3.0, 2.5), 1.0);
    const std::vector<Receiver> one = {mesh->vertices[0].receiver};
    EXPECT_FALSE(seen_sums(*mesh, one, OccluderSet{}, Work{1, stop.get_token(), nullptr}));
}

}  // namespace
}  // namespace hanei
