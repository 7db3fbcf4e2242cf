#include "engine/transport/balance.h"

#include "tests/unit/transport/balanced_room.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace hanei {
namespace {

struct Room : BalancedRoom {
    using BalancedRoom::BalancedRoom;
    Balance solve(BalanceLimits limits, int threads = 2) const { return *balance(input(), limits, {threads}); }
};

double greatest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

/// Two unknowns that see each other with the factors a and b: the answer is a fraction.
struct TwoPlates {
    DenseRows factors{2, 2, {0.0F, 0.5F, 0.25F, 0.0F}};
    std::vector<double> reflectance{0.8, 0.6}, direct{100.0, 20.0}, own{0.0, 5.0};
    BalanceInput input() const { return {&factors, nullptr, reflectance, direct, own}; }
};

TEST(Balance, two_plates_meet_the_answer_on_paper) {
    const TwoPlates plates;
    const Balance found = *balance(plates.input(), {1000, 1e-13}, {});
    // E1 = 0.5 B2, E2 = 0.25 B1, B = own + rho (direct + E)
    const double b1 = (80.0 + 0.4 * 17.0) / (1.0 - 0.4 * 0.15);
    const double b2 = 17.0 + 0.15 * b1;
    EXPECT_NEAR(found.exitance[0], b1, 1e-9);  // accuracy 1e-13 of 110 lx, and rounding
    EXPECT_NEAR(found.exitance[1], b2, 1e-9);
    EXPECT_NEAR(found.interreflected[0], 0.5 * b2, 1e-9);
    EXPECT_TRUE(found.converged);
    EXPECT_NEAR(found.greatest_row_sum, 0.3, 1e-7);
}

TEST(Balance, a_closed_room_of_reflectance_one_half_doubles_the_emitted_exitance) {
    Room room(sample::computer_room(0.5));
    std::fill(room.direct.begin(), room.direct.end(), 0.0);
    for (std::size_t k = 0; k < room.own.size(); ++k) {
        room.own[k] = 10.0;
        room.reflectance[k] = 0.5;
    }
    const Balance found = room.solve({1000, 1e-9});
    EXPECT_TRUE(found.converged);
    for (const double exitance : found.exitance) EXPECT_NEAR(exitance, 20.0, 1e-4);  // row sums 1 within 1e-6
}

TEST(Balance, the_bracket_contains_the_converged_solution_at_every_bounce) {
    const Room room(sample::computer_room(0.7));
    const Balance converged = room.solve({1000, 1e-12});
    ASSERT_TRUE(converged.converged);
    int states = 0;
    const auto check = [&](const Balance& state) {
        for (std::size_t k = 0; k < state.exitance.size(); ++k) {
            EXPECT_LE(std::abs(state.exitance[k] - converged.exitance[k]),
                      state.exitance_half_width[k] + converged.exitance_half_width[k]);
        }
        return ++states > 0;
    };
    ASSERT_TRUE(balance(room.input(), {1000, 1e-6}, {2}, check));
    EXPECT_GT(states, 5);
}

TEST(Balance, stops_when_the_bracket_is_as_close_as_asked) {
    const Room room(sample::computer_room(0.6));
    const Balance exact = room.solve({1000, 1e-12});
    for (const double accuracy : {1e-2, 1e-3, 1e-5}) {
        const Balance found = room.solve({1000, accuracy});
        EXPECT_TRUE(found.converged);
        double total = 0.0, worst = 0.0;
        for (std::size_t k = 0; k < room.direct.size(); ++k) {
            total = std::max(total, room.direct[k] + exact.interreflected[k]);
            worst = std::max(worst, std::abs(found.interreflected[k] - exact.interreflected[k]));
        }
        EXPECT_LE(worst, accuracy * total);
        EXPECT_LT(found.bounces, exact.bounces);
    }
}

TEST(Balance, a_fixed_number_of_bounces_gives_the_partial_sum_and_a_bound_on_the_rest) {
    const Room room(sample::computer_room(0.6));
    const Balance four = room.solve({4, 1e-12});
    EXPECT_EQ(four.bounces, 4);
    EXPECT_FALSE(four.converged);
    std::vector<double> leaving(room.direct.size()), sum(room.direct.size(), 0.0);
    for (std::size_t k = 0; k < leaving.size(); ++k) leaving[k] = room.reflectance[k] * room.direct[k];
    for (int bounce = 0; bounce < 4; ++bounce) {
        const std::vector<double> arriving = gather(room.factors, &room.visibility, leaving, {2});
        for (std::size_t k = 0; k < leaving.size(); ++k) {
            sum[k] += arriving[k];
            leaving[k] = room.reflectance[k] * arriving[k];
        }
    }
    const Balance exact = room.solve({1000, 1e-12});
    for (std::size_t k = 0; k < sum.size(); ++k) {
        EXPECT_NEAR(four.interreflected[k], sum[k], 1e-12 * greatest(sum));  // the same sums
        EXPECT_LE(exact.exitance[k], four.exitance[k] + four.exitance_half_width[k]);
        EXPECT_GE(exact.exitance[k], four.exitance[k]);
    }
}

TEST(Balance, no_bounce_at_all_still_bounds_what_it_leaves_out) {
    const Room room(sample::box_room(4.0, 3.0, 2.5, 0.5));
    const Balance none = room.solve({0, 1e-3});
    EXPECT_EQ(none.bounces, 0);
    EXPECT_EQ(greatest(none.interreflected), 0.0);
    const Balance exact = room.solve({1000, 1e-12});
    for (std::size_t k = 0; k < exact.exitance.size(); ++k) {
        EXPECT_LE(exact.exitance[k], none.exitance[k] + none.exitance_half_width[k]);
    }
}

TEST(Balance, reflectance_of_99_percent_converges_with_its_bracket) {
    const Room room(sample::box_room(4.0, 3.0, 2.5, 0.99), 1.0);
    const Balance found = room.solve({1000, 1e-3});
    EXPECT_TRUE(found.converged);
    EXPECT_LT(found.bounces, 400);  // the plain series needs 682
    const Balance exact = room.solve({100'000, 1e-9});
    for (std::size_t k = 0; k < exact.exitance.size(); ++k) {
        EXPECT_LE(std::abs(found.exitance[k] - exact.exitance[k]),
                  found.exitance_half_width[k] + exact.exitance_half_width[k]);
    }
}

TEST(Balance, reflectance_1_in_a_closed_room_ends_and_says_so) {
    const Room room(sample::box_room(4.0, 3.0, 2.5, 1.0), 1.0);
    const Balance found = room.solve({1000, 1e-3});
    EXPECT_FALSE(found.converged);
    EXPECT_NEAR(found.greatest_row_sum, 1.0, 1e-6);
    for (std::size_t k = 0; k < found.exitance.size(); ++k) {
        EXPECT_TRUE(std::isfinite(found.exitance[k]));
        EXPECT_TRUE(std::isfinite(found.exitance_half_width[k]));
        EXPECT_GT(found.exitance_half_width[k], found.exitance[k]);
    }
}

TEST(Balance, factors_that_run_away_end_with_finite_figures) {
    TwoPlates plates;
    plates.factors.values = {0.0F, 900.0F, 900.0F, 0.0F};  // grid points 1 mm apart
    const Balance found = *balance(plates.input(), {1000, 1e-3}, {});
    EXPECT_FALSE(found.converged);
    EXPECT_TRUE(std::isfinite(found.exitance[0]));
    EXPECT_TRUE(std::isfinite(found.exitance_half_width[0]));
}

TEST(Balance, a_dark_or_black_room_is_done_at_once) {
    Room black(sample::box_room(4.0, 3.0, 2.5, 0.0));
    const Balance found = black.solve({1000, 1e-3});
    EXPECT_TRUE(found.converged);
    EXPECT_EQ(found.bounces, 0);
    EXPECT_EQ(greatest(found.exitance), 0.0);
    Room dark(sample::box_room(4.0, 3.0, 2.5, 0.5));
    std::fill(dark.direct.begin(), dark.direct.end(), 0.0);
    EXPECT_TRUE(dark.solve({1000, 1e-3}).converged);
}

TEST(Balance, the_same_bits_on_one_thread_on_two_and_on_seven) {
    const Room room(sample::computer_room(0.6));
    const Balance one = room.solve({1000, 1e-6}, 1);
    for (const int threads : {2, 7}) {
        const Balance many = room.solve({1000, 1e-6}, threads);
        EXPECT_EQ(one.interreflected, many.interreflected);
        EXPECT_EQ(one.exitance, many.exitance);
        EXPECT_EQ(one.exitance_half_width, many.exitance_half_width);
    }
}

TEST(Balance, ends_when_told_to) {
    const Room room(sample::box_room(4.0, 3.0, 2.5, 0.8));
    int seen = 0;
    EXPECT_FALSE(balance(room.input(), {1000, 1e-9}, {}, [&](const Balance&) { return ++seen < 3; }));
    EXPECT_EQ(seen, 3);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(balance(room.input(), {1000, 1e-9}, {1, stop.get_token(), nullptr}));
}

TEST(Balance, a_patch_takes_the_mean_exitance_of_its_corners) {
    const auto mesh = make_mesh(sample::box_room(1.0, 1.0, 1.0), 1.0);
    std::vector<double> at_vertices(mesh->vertices.size(), 0.0);
    for (std::uint32_t k = 0; k < 4; ++k) at_vertices[k] = k;
    const std::vector<double> of_patches = patch_exitance(*mesh, at_vertices);
    EXPECT_EQ(of_patches[0], 1.5);
    EXPECT_EQ(of_patches[1], 0.0);
}

}  // namespace
}  // namespace hanei
