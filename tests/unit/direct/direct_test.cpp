#include "tests/unit/direct/scenes.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

using testing::floor_point;
using testing::luminaire_at;
using testing::panel;
using testing::sheet;

const Scene bare;

/// The mean over a rectangle of the floor by n x n midpoints.
double summed_mean(const Emitter& emitter, const Vec2& low, const Vec2& high, const OccluderSet* occluders, int n) {
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const Vec2 at = low + (high - low) * Vec2{(i + 0.5) / n, (j + 0.5) / n};
            sum += emitter.illuminance(floor_point(at.x, at.y), occluders).value;
        }
    }
    return sum / (n * n);
}

double mean(const Emitter& emitter, const Polygon& polygon, const OccluderSet* occluders) {
    const ReceivingPolygon receiving{polygon, {0, 0, 1}};
    return mean_direct_illuminance(emitter, {&receiving, 1}, occluders, {})->front();
}

Polygon floor_patch(const Vec2& low, const Vec2& high) {
    return {{low.x, low.y, 0}, {high.x, low.y, 0}, {high.x, high.y, 0}, {low.x, high.y, 0}};
}

TEST(MeanDirect, in_free_light_it_is_the_mean_of_many_points) {
    const Emitter emitter(bare, luminaire_at({0, 0, 2.5}, panel(1.2, 0.6), Luminance{5000}));
    for (const double x : {0.0, 0.7, 2.0}) {
        const Vec2 low{x, 0.1}, high{x + 0.5, 0.6};
        const double expected = summed_mean(emitter, low, high, nullptr, 100);
        EXPECT_NEAR(mean(emitter, floor_patch(low, high), nullptr) / expected, 1, 1e-4);
    }
}

TEST(MeanDirect, in_penumbra_it_is_the_mean_of_many_points) {
    const Emitter emitter(bare, luminaire_at({0, 0, 2.5}, panel(1.2, 0.6), Luminance{5000}));
    const OccluderSet set({sheet({{0.2, -3, 0.75}, {3, -3, 0.75}, {3, 3, 0.75}, {0.2, 3, 0.75}})});
    for (const double x : {-0.3, -0.05, 0.2, 0.35}) {
        const Vec2 low{x, 0.1}, high{x + 0.25, 0.35};
        const double expected = summed_mean(emitter, low, high, &set, 200);
        const double greatest = emitter.illuminance(floor_point(0, 0), nullptr).value;
        EXPECT_NEAR(mean(emitter, floor_patch(low, high), &set), expected, 2e-3 * greatest) << x;
    }
}

TEST(MeanDirect, a_triangle_and_its_mirror_make_the_rectangle) {
    const Emitter emitter(bare, luminaire_at({0, 0, 2.5}, panel(1.2, 0.6), Luminance{5000}));
    const Polygon whole = floor_patch({0.3, 0.2}, {0.7, 0.6});
    const double halves = 0.5 * (mean(emitter, {whole[0], whole[1], whole[2]}, nullptr) +
                                 mean(emitter, {whole[0], whole[2], whole[3]}, nullptr));
    EXPECT_NEAR(halves / mean(emitter, whole, nullptr), 1, 1e-4);
    const Polygon six = {{0.3, 0.2, 0}, {0.5, 0.2, 0}, {0.7, 0.2, 0}, {0.7, 0.6, 0}, {0.5, 0.6, 0}, {0.3, 0.6, 0}};
    EXPECT_NEAR(mean(emitter, six, nullptr) / mean(emitter, whole, nullptr), 1, 1e-4);
}

TEST(MeanDirect, without_area_there_is_no_light) {
    const Emitter emitter(bare, luminaire_at({0, 0, 2.5}, panel(1.2, 0.6), Luminance{5000}));
    EXPECT_EQ(mean(emitter, {}, nullptr), 0.0);
    EXPECT_EQ(mean(emitter, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, nullptr), 0.0);
}

TEST(Direct, the_same_bits_on_one_thread_and_on_seven) {
    const Emitter emitter(bare, luminaire_at({0, 0, 2.5}, panel(1.2, 0.6), Luminance{5000}));
    const OccluderSet set({sheet({{0.2, -3, 0.75}, {3, -3, 0.75}, {3, 3, 0.75}, {0.2, 3, 0.75}})});
    std::vector<Receiver> receivers;
    std::vector<Polygon> patches;
    for (int k = 0; k < 1000; ++k) {
        const double x = -2 + 0.1 * (k % 40), y = -1 + 0.08 * (k / 40);
        receivers.push_back(floor_point(x, y));
        patches.push_back(floor_patch({x, y}, {x + 0.1, y + 0.08}));
    }
    std::vector<ReceivingPolygon> receiving;
    for (const Polygon& patch : patches) receiving.push_back({patch, {0, 0, 1}});
    EXPECT_EQ(*direct_illuminance(emitter, receivers, &set, {1, {}, nullptr}),
              *direct_illuminance(emitter, receivers, &set, {7, {}, nullptr}));
    EXPECT_EQ(*mean_direct_illuminance(emitter, receiving, &set, {1, {}, nullptr}),
              *mean_direct_illuminance(emitter, receiving, &set, {7, {}, nullptr}));
}

TEST(Direct, being_stopped_returns_nothing) {
    const Emitter emitter(bare, luminaire_at({0, 0, 2.5}, panel(1.2, 0.6), Luminance{5000}));
    const std::vector<Receiver> receivers(1000);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(direct_illuminance(emitter, receivers, nullptr, {1, stop.get_token(), nullptr}));
    EXPECT_FALSE(
        mean_direct_illuminance(emitter, std::vector<ReceivingPolygon>(9), nullptr, {1, stop.get_token(), nullptr}));
}

}  // namespace
}  // namespace hanei
