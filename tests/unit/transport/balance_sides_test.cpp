#include "engine/transport/balance.h"
#include "tests/unit/transport/balanced_room.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

/// Sides of one room: its light, and twice its light on darker surfaces.
struct TwoSides {
    BalancedRoom room{sample::computer_room(0.7)};
    std::vector<double> darker, brighter;

    TwoSides() {
        for (const double reflectance : room.reflectance) darker.push_back(0.5 * reflectance);
        for (const double direct : room.direct) brighter.push_back(2.0 * direct);
    }
    std::vector<LightSide> sides() const {
        return {{room.reflectance, room.direct, room.own}, {darker, brighter, room.own}};
    }
    std::optional<std::vector<Balance>> solve(const BalanceLimits& limits, int threads = 2) const {
        return balance(room.exchange({threads}), room.direct.size(), sides(), limits, {threads});
    }
};

TEST(SidesOfLight, each_is_balanced_as_if_it_were_alone) {
    const TwoSides both;
    const std::vector<Balance> found = *both.solve({1000, 1e-9});
    const std::vector<LightSide> sides = both.sides();
    for (std::size_t s = 0; s < sides.size(); ++s) {
        BalanceInput alone = both.room.input();
        alone.reflectance = sides[s].reflectance;
        alone.direct = sides[s].direct;
        const Balance expected = *balance(alone, {1000, 1e-11}, {2});
        ASSERT_TRUE(found[s].converged);
        for (std::size_t k = 0; k < expected.exitance.size(); ++k) {
            EXPECT_LE(std::abs(found[s].exitance[k] - expected.exitance[k]),
                      found[s].exitance_half_width[k] + expected.exitance_half_width[k]);
        }
    }
}

TEST(SidesOfLight, the_same_bits_on_one_thread_on_two_and_on_seven) {
    const TwoSides both;
    const std::vector<Balance> one = *both.solve({1000, 1e-6}, 1);
    for (const int threads : {2, 7}) {
        const std::vector<Balance> many = *both.solve({1000, 1e-6}, threads);
        for (std::size_t s = 0; s < one.size(); ++s) {
            EXPECT_EQ(one[s].interreflected, many[s].interreflected);
            EXPECT_EQ(one[s].exitance, many[s].exitance);
            EXPECT_EQ(one[s].exitance_half_width, many[s].exitance_half_width);
        }
    }
}

TEST(SidesOfLight, a_fixed_number_of_bounces_gives_the_partial_sums) {
    const TwoSides both;
    const std::vector<Balance> found = *both.solve({4, 1e-12});
    const std::vector<LightSide> sides = both.sides();
    for (std::size_t s = 0; s < sides.size(); ++s) {
        EXPECT_EQ(found[s].bounces, 4);
        BalanceInput alone = both.room.input();
        alone.reflectance = sides[s].reflectance;
        alone.direct = sides[s].direct;
        const Balance expected = *balance(alone, {4, 1e-12}, {2});
        for (std::size_t k = 0; k < expected.exitance.size(); ++k)  // to the order of a sum of a thousand products
            EXPECT_NEAR(found[s].interreflected[k], expected.interreflected[k], 1e-12 * expected.interreflected[k]);
    }
}

TEST(SidesOfLight, a_stopped_balance_returns_nothing) {
    const TwoSides both;
    std::stop_source stop;
    stop.request_stop();
    const Work work{1, stop.get_token(), nullptr};
    EXPECT_FALSE(balance(both.room.exchange(work), both.room.direct.size(), both.sides(), {1000, 1e-9}, work));
}

}  // namespace
}  // namespace hanei
