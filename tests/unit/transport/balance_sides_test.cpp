#include "engine/transport/balance.h"
#include "tests/unit/transport/balanced_room.h"

#include <algorithm>
#include <cmath>
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

/// The greatest error of what arrives, of the greatest total illuminance; and every error within its bound.
double error_within_bound(const BalancedRoom& room, const Balance& found, const Balance& exact) {
    double total = 0.0, error = 0.0;
    for (std::size_t k = 0; k < room.size(); ++k) {
        EXPECT_LE(std::abs(found.exitance[k] - exact.exitance[k]),
                  found.exitance_half_width[k] + exact.exitance_half_width[k]);
        total = std::max(total, room.direct[k] + exact.interreflected[k]);
        error = std::max(error, std::abs(found.interreflected[k] - exact.interreflected[k]));
    }
    return error / total;
}

/// A furnished room with the reflectances of an office: 0.8 ceiling, 0.5 walls, 0.2 floor.
BalancedRoom office() {
    BalancedRoom room(sample::computer_room(0.5), 0.5);
    for (std::size_t k = 0; k < room.size(); ++k) {
        const double height = room.mesh->patches[k].centre.z;
        room.reflectance[k] = height > 2.99 ? 0.8 : height < 0.01 ? 0.2 : 0.5;
    }
    return room;
}

Balance solve(const BalancedRoom& room, const BalanceLimits& limits, std::span<const double> guess = {},
              std::span<const double> guess_arriving = {}) {
    const LightSide side{room.reflectance, room.direct, room.own, guess, guess_arriving};
    return balance(room.exchange(), room.size(), {&side, 1}, limits, {2})->front();
}

TEST(SidesOfLight, an_office_takes_6_products_to_a_thousandth_and_12_to_a_millionth) {
    const BalancedRoom room = office();
    const Balance exact = solve(room, {1000, 1e-12});
    ASSERT_TRUE(exact.converged);
    for (const auto& [accuracy, most] : {std::pair(1e-3, 6), std::pair(1e-6, 12)}) {
        const Balance found = solve(room, {1000, accuracy});
        EXPECT_TRUE(found.converged);
        EXPECT_LE(found.products, most);
        EXPECT_LE(error_within_bound(room, found, exact), accuracy);
    }
}

TEST(SidesOfLight, reflectance_of_99_percent_takes_60_products_to_a_millionth) {
    BalancedRoom room(sample::computer_room(0.99));
    const Balance exact = *balance(room.input(), {100'000, 1e-10}, {2});
    const Balance found = solve(room, {1000, 1e-6});
    EXPECT_TRUE(found.converged);
    EXPECT_LE(found.products, 60);
    EXPECT_LE(error_within_bound(room, found, exact), 1e-6);
}

TEST(SidesOfLight, a_closed_room_of_reflectance_1_with_one_dark_wall_is_solved) {
    BalancedRoom room(sample::l_room(1.0), 0.5);
    for (std::size_t k = 0; k < room.size(); ++k) {
        if (room.mesh->patches[k].centre.x > 3.99) room.reflectance[k] = 0.1;  // the end of one corridor
    }
    const Balance found = solve(room, {1000, 1e-4});
    EXPECT_TRUE(found.converged);
    EXPECT_LE(found.products, 40);
    EXPECT_LE(error_within_bound(room, found, *balance(room.input(), {100'000, 1e-8}, {2})), 1e-4);
    for (float& factor : room.factors.values) factor *= 1.001F;  // rows kept in few bits seem to gain light
    EXPECT_TRUE(solve(room, {1000, 1e-4}).converged);
}

TEST(SidesOfLight, a_closed_room_of_reflectance_1_has_no_balance_and_says_so) {
    const BalancedRoom room(sample::box_room(4.0, 3.0, 2.5, 1.0), 1.0);
    const Balance found = solve(room, {1000, 1e-3});
    EXPECT_FALSE(found.converged);
    for (std::size_t k = 0; k < room.size(); ++k) {
        EXPECT_TRUE(std::isfinite(found.exitance[k]));
        EXPECT_GT(found.exitance_half_width[k], found.exitance[k]);
    }
}

TEST(SidesOfLight, every_state_lies_within_its_bound_and_the_bound_is_near_the_error) {
    const BalancedRoom room = office();
    const Balance exact = solve(room, {1000, 1e-12});
    const LightSide side{room.reflectance, room.direct, room.own};
    std::vector<double> medians;
    const auto look = [&](std::span<const Balance> states) {
        error_within_bound(room, states[0], exact);
        std::vector<double> ratios;
        for (std::size_t k = 0; k < room.size(); ++k) {
            const double error = std::abs(states[0].exitance[k] - exact.exitance[k]);
            ratios.push_back(states[0].exitance_half_width[k] / std::max(error, 1e-30));
        }
        std::nth_element(ratios.begin(), ratios.begin() + ratios.size() / 2, ratios.end());
        medians.push_back(ratios[ratios.size() / 2]);
        return true;
    };
    ASSERT_TRUE(balance(room.exchange(), room.size(), {&side, 1}, {1000, 1e-6}, {2}, look));
    EXPECT_GT(medians.size(), 6U);
    std::nth_element(medians.begin(), medians.begin() + medians.size() / 2, medians.end());
    EXPECT_GE(medians[medians.size() / 2], 1.0);
    EXPECT_LE(medians[medians.size() / 2], 10.0);  // measured 2 to 8; an error has both signs, a bound one size
}

TEST(SidesOfLight, the_first_states_are_the_sums_of_one_two_and_three_bounces) {
    const BalancedRoom room = office();
    const LightSide side{room.reflectance, room.direct, room.own};
    int seen = 0;
    const auto look = [&](std::span<const Balance> states) {
        ++seen;
        const Balance sum = *balance(room.input(), {seen, 1e-12}, {2});
        EXPECT_EQ(states[0].bounces, seen);
        for (std::size_t k = 0; k < room.size(); ++k)  // the same sums in another order
            EXPECT_NEAR(states[0].interreflected[k], sum.interreflected[k], 1e-12 * sum.interreflected[k]);
        return seen < 3;
    };
    EXPECT_FALSE(balance(room.exchange(), room.size(), {&side, 1}, {1000, 1e-6}, {2}, look));
    EXPECT_EQ(seen, 3);
}

TEST(SidesOfLight, a_dimmed_side_takes_one_product_and_one_that_is_kept_takes_no_more) {
    BalancedRoom room = office();
    const Balance before = solve(room, {1000, 1e-9});
    for (double& direct : room.direct) direct *= 0.3;
    const Balance dimmed = solve(room, {1000, 1e-6}, before.exitance);
    EXPECT_EQ(dimmed.products, 1);
    EXPECT_LE(error_within_bound(room, dimmed, solve(room, {1000, 1e-12})), 1e-6);
    EXPECT_EQ(solve(room, {1000, 1e-6}, before.sent, before.arrived).products, 1);
}

TEST(SidesOfLight, one_of_many_luminaires_that_moved_takes_3_products_to_a_thousandth) {
    BalancedRoom room = office();
    const Balance before = solve(room, {1000, 1e-6});
    for (std::size_t k = 0; k < room.size(); ++k) {  // one of twenty-five lit another part of the floor
        const Vec3& centre = room.mesh->patches[k].centre;
        if (centre.z < 0.1 && centre.x < 2.0) room.direct[k] += centre.y < 3.0 ? 15.0 : -15.0;
    }
    const Balance moved = solve(room, {1000, 1e-3}, before.sent, before.arrived);
    EXPECT_TRUE(moved.converged);
    EXPECT_LE(moved.products, 3);
    EXPECT_LE(error_within_bound(room, moved, solve(room, {1000, 1e-12})), 1e-3);
}

TEST(SidesOfLight, a_guess_of_any_kind_leads_to_the_same_answer) {
    const BalancedRoom room = office();
    const Balance exact = solve(room, {1000, 1e-12});
    const std::vector<double> dark(room.size(), 0.0), wrong(room.size(), -7.0);
    std::vector<double> spot(room.size(), 0.0);
    spot[3] = 1e9;
    for (const std::vector<double>& guess : {dark, wrong, spot}) {
        const Balance found = solve(room, {1000, 1e-6}, guess);
        EXPECT_TRUE(found.converged);
        EXPECT_LE(found.products, 14);
        EXPECT_LE(error_within_bound(room, found, exact), 1e-6);
    }
}

TEST(SidesOfLight, black_surfaces_that_emit_are_known_at_once) {
    BalancedRoom room(sample::box_room(4.0, 3.0, 2.5, 0.0));
    room.own.assign(room.size(), 10.0);
    const Balance found = solve(room, {1000, 1e-9});
    EXPECT_TRUE(found.converged);
    EXPECT_EQ(found.products, 1);
    for (const double arriving : found.interreflected) EXPECT_NEAR(arriving, 10.0, 1e-5);  // row sums 1 within 1e-6
    room.own.assign(room.size(), 0.0);
    const Balance dark = solve(room, {1000, 1e-9});
    EXPECT_TRUE(dark.converged);
    EXPECT_EQ(dark.bounces, 0);
}

/// Unknowns in a ring, each lit by the one before alone: rows as far from symmetric as can be.
void expect_solved_ring(std::size_t count, double reflectance, double accuracy) {
    const Exchange ring = [count](std::span<const double> leaving, std::span<double> arriving, std::size_t sides) {
        for (std::size_t k = 0; k < count * sides; ++k)
            arriving[k] = leaving[(k + (count - 1) * sides) % (count * sides)];
        return true;
    };
    const std::vector<double> reflectances(count, reflectance), own(count, 0.0);
    std::vector<double> direct(count, 0.0);
    direct[0] = 100.0;
    const LightSide side{reflectances, direct, own};
    const Balance found = balance(ring, count, {&side, 1}, {100'000, accuracy}, {})->front();
    EXPECT_TRUE(found.converged);
    const double around = std::pow(reflectance, static_cast<double>(count));
    for (std::size_t k = 0; k < count; ++k) {
        const double once = 100.0 * std::pow(reflectance, static_cast<double>(k == 0 ? count : k));
        EXPECT_NEAR(found.interreflected[k], once / (1.0 - around), accuracy * 100.0 / (1.0 - around));
    }
}

TEST(SidesOfLight, rows_without_any_symmetry_converge) {
    expect_solved_ring(60, 0.95, 1e-9);
    expect_solved_ring(300, 0.9995, 1e-2);  // no mixture of sixteen does better than one reflection after another
}

TEST(SidesOfLight, rows_that_run_away_are_summed_and_end_with_finite_figures) {
    const DenseRows near{2, 2, {0.0F, 900.0F, 900.0F, 0.0F}};  // grid points 1 mm apart
    const std::vector<double> reflectance{0.8, 0.6}, direct{100.0, 20.0}, own{0.0, 5.0};
    const LightSide side{reflectance, direct, own, direct};
    const Balance found = balance(exchange_by(near, nullptr, {}), 2, {&side, 1}, {1000, 1e-3}, {})->front();
    EXPECT_FALSE(found.converged);
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_TRUE(std::isfinite(found.exitance[k]));
        EXPECT_TRUE(std::isfinite(found.exitance_half_width[k]));
        EXPECT_GT(found.exitance_half_width[k], found.exitance[k]);
    }
}

TEST(SidesOfLight, more_than_is_possible_in_doubles_ends_at_their_rounding) {
    const BalancedRoom room = office();
    const Balance found = solve(room, {1000, 1e-18});
    EXPECT_FALSE(found.converged);
    EXPECT_LT(found.products, 40);
    EXPECT_LE(error_within_bound(room, found, solve(room, {1000, 1e-12})), 1e-12);
}

TEST(SidesOfLight, nothing_to_balance_is_an_answer) {
    EXPECT_TRUE(balance(TwoSides().room.exchange(), 3, {}, {1000, 1e-3}, {})->empty());
    const LightSide none{};
    const DenseRows no_rows;
    EXPECT_TRUE(balance(exchange_by(no_rows, nullptr, {}), 0, {&none, 1}, {1000, 1e-3}, {})->front().converged);
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
