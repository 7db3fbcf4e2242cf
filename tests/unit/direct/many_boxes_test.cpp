/// As many boxes as a city has: light finds its way past all of them, and past those that are in it.
#include "engine/direct/direct.h"
#include "tests/unit/direct/scenes.h"
#include "tests/unit/geometry/shapes.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

using testing::floor_point;
using testing::luminaire_at;

/// 316 x 316 cubes of 5 cm on a floor of 32 m, 5 cm apart; the origin is a crossing of their lanes.
OccluderSet hundred_thousand_boxes() {
    constexpr int along = 316;
    constexpr double pitch = 0.1, gap = 0.05;
    std::vector<ConvexBody> bodies;
    for (int k = 0; k < along * along; ++k) {
        const Vec3 low{pitch * (k % along - along / 2) + 0.5 * gap, pitch * (k / along - along / 2) + 0.5 * gap, 0.0};
        bodies.push_back(testing::box_body(low, low + Vec3{pitch - gap}));
    }
    return OccluderSet(std::move(bodies));
}

TEST(ManyBoxes, a_hundred_thousand_hide_only_what_is_behind_them) {
    const OccluderSet boxes = hundred_thousand_boxes();
    ASSERT_EQ(boxes.bodies().size(), 99856U);
    const Emitter panel(Scene{}, luminaire_at({0, 0, 2.5}, testing::panel(0.8, 0.4), LuminousFlux{3000}));
    const auto seen = [&](const Receiver& receiver) { return panel.illuminance(receiver, &boxes).value; };
    const auto free = [&](const Receiver& receiver) { return panel.illuminance(receiver, nullptr).value; };
    EXPECT_EQ(seen(floor_point(0, 0)), free(floor_point(0, 0))) << "steeply past the nearest";
    EXPECT_GT(free(floor_point(10, 10)), 0);
    EXPECT_EQ(seen(floor_point(10, 10)), 0) << "flat, behind the nearest";
    // Hard by the side of a lane: the second box cuts the panel off along a line, by similar triangles.
    const double y = 0.0235, edge_x = 9.825, edge_y = 0.025;
    const auto cut = [&](double x) { return y + (edge_y - y) * (10 - x) / (10 - edge_x); };
    const PolygonOpening part{{{{-0.4, -0.2, 0}, {-0.4, cut(-0.4), 0}, {0.4, cut(0.4), 0}, {0.4, -0.2, 0}}, {}}};
    const double share = (0.5 * (cut(-0.4) + cut(0.4)) + 0.2) / 0.4;
    const Emitter rest(Scene{}, luminaire_at({0, 0, 2.5}, part, LuminousFlux{3000 * share}));
    const double right = rest.illuminance(floor_point(10, y), nullptr).value;
    EXPECT_NEAR(seen(floor_point(10, y)) / right, 1, 1e-9);
    Receiver above = floor_point(10, 10);
    above.position.z = 0.06;
    EXPECT_EQ(seen(above), free(above)) << "over all of them";
}

}  // namespace
}  // namespace hanei
