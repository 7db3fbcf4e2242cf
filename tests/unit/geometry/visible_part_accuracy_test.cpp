#include "engine/geometry/visible_part.h"
#include "tests/unit/geometry/shapes.h"
#include "tests/unit/geometry/visible_part_reference.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace hanei {
namespace {

using testing::box_body;
using testing::Dice;
using testing::facing_down;
using testing::long_visible_factor;

/// Boxes in a room of 6 x 4 m; on a grid of 5 cm their edges coincide, and coincide with receivers.
OccluderSet boxes_in_a_room(Dice& dice, int count, double grid) {
    const auto snapped = [&](double value) { return grid > 0.0 ? grid * std::round(value / grid) : value; };
    std::vector<ConvexBody> bodies;
    for (int k = 0; k < count; ++k) {
        const Vec3 half = 0.5 * Vec3{snapped(dice.uniform(0.1, 0.6)), snapped(dice.uniform(0.1, 0.6)),
                                     snapped(dice.uniform(0.1, 0.6))};
        const Vec3 at{snapped(dice.uniform(0, 6)), snapped(dice.uniform(0, 4)), snapped(dice.uniform(0.3, 2.3))};
        ConvexBody body = box_body(-half, half);
        const Mat3 turn = grid > 0.0 || k % 2 == 0 ? Mat3{1.0} : dice.rotation();
        for (Vec3& vertex : body.vertices) vertex = turn * vertex + at;
        bodies.push_back(std::move(body));
    }
    return OccluderSet(std::move(bodies));
}

OccluderSet sticks_in_a_room(Dice& dice, int count) {
    std::vector<ConvexBody> bodies;
    for (int k = 0; k < count; ++k) {
        const Vec3 half{0.01, 0.01, dice.uniform(0.2, 0.8)};
        ConvexBody body = box_body(-half, half);
        const Mat3 turn = dice.rotation();
        const Vec3 at{dice.uniform(0, 6), dice.uniform(0, 4), dice.uniform(0.9, 2.4)};
        for (Vec3& vertex : body.vertices) vertex = turn * vertex + at;
        bodies.push_back(std::move(body));
    }
    return OccluderSet(std::move(bodies));
}

struct Compared {
    double worst = 0.0;  ///< difference over the greatest factor met
    int penumbra = 0;
};

Compared compared(Dice& dice, const OccluderSet& set, int receivers) {
    Compared result;
    double worst = 0.0, greatest = 0.0;
    std::vector<BodyIndex> found;
    for (int k = 0; k < receivers; ++k) {
        const double x = dice.uniform(1, 5), y = dice.uniform(1, 3);
        const Polygon panel = facing_down(x - 0.6, y - 0.3, x + 0.6, y + 0.3, 2.8);
        const Receiver receiver{{dice.uniform(0, 6), dice.uniform(0, 4), 0.013}, {0, 0, 1}, {}};
        if (set.containing(receiver.position) >= 0) continue;
        found.clear();
        set.between(receiver.position, panel, found);
        const double got = visible_configuration_factor(panel, receiver, set, found);
        const auto whole = configuration_factor(panel, receiver);
        const auto exact = static_cast<double>(long_visible_factor(panel, receiver, set));
        worst = std::max(worst, std::abs(got - exact));
        greatest = std::max(greatest, whole);
        result.penumbra += got > 0.0 && got < whole;
    }
    result.worst = worst / greatest;
    return result;
}

// A hundred roundings of a cut, summed over at most a few hundred pieces, stay far below.
constexpr double of_the_greatest = 1e-12;

TEST(VisiblePartAccuracy, double_agrees_with_long_double_among_boxes) {
    Dice dice(31);
    for (const int count : {10, 40, 150, 600}) {
        const OccluderSet set = boxes_in_a_room(dice, count, 0.0);
        EXPECT_LT(compared(dice, set, count > 100 ? 40 : 150).worst, of_the_greatest) << count;
    }
    EXPECT_GT(compared(dice, boxes_in_a_room(dice, 40, 0.0), 100).penumbra, 30);
}

TEST(VisiblePartAccuracy, double_agrees_with_long_double_where_edges_coincide) {
    Dice dice(32);
    for (const int count : {10, 40, 150, 600}) {
        const OccluderSet set = boxes_in_a_room(dice, count, 0.05);
        EXPECT_LT(compared(dice, set, count > 100 ? 40 : 150).worst, of_the_greatest) << count;
    }
}

TEST(VisiblePartAccuracy, double_agrees_with_long_double_among_sticks) {
    Dice dice(33);
    for (const int count : {20, 100, 300}) {
        const Compared result = compared(dice, sticks_in_a_room(dice, count), count > 100 ? 10 : 60);
        EXPECT_LT(result.worst, of_the_greatest) << count;
        EXPECT_GT(result.penumbra, 5) << count;
    }
}

}  // namespace
}  // namespace hanei
