#include "engine/study/frontier.h"

#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace hanei {
namespace {

using Indices = std::vector<std::size_t>;

TEST(Frontier, leaves_out_what_another_beats_in_both) {
    const std::vector<CostAndError> ways{{3.0, 0.1}, {1.0, 0.5}, {2.0, 0.6}, {4.0, 0.1}, {10.0, 0.05}};
    EXPECT_EQ(pareto_frontier(ways), (Indices{1, 0, 4}));
}

TEST(Frontier, ends_where_errors_cannot_be_told_apart) {
    const std::vector<CostAndError> ways{{1.0, 0.5}, {2.0, 0.08}, {5.0, 0.01}};
    EXPECT_EQ(pareto_frontier(ways, 0.1), (Indices{0, 1})) << "below the floor more time buys nothing";
}

TEST(Frontier, takes_the_most_exact_of_times_that_are_alike) {
    const std::vector<CostAndError> ways{{100.0, 0.5}, {102.0, 0.4}, {103.0, 0.3}, {105.0, 0.2}};
    EXPECT_EQ(pareto_frontier(ways, 0.0, 0.04), (Indices{2, 3})) << "the fourth is 5 % dearer than the first";
}

TEST(Frontier, is_empty_of_nothing_and_passes_over_what_is_no_number) {
    EXPECT_TRUE(pareto_frontier({}).empty());
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::vector<CostAndError> ways{{std::numeric_limits<double>::quiet_NaN(), 0.0},
                                         {1.0, std::numeric_limits<double>::quiet_NaN()},
                                         {infinity, 0.0},
                                         {-1.0, 0.0},
                                         {2.0, 0.3}};
    EXPECT_EQ(pareto_frontier(ways), Indices{4});
}

TEST(Frontier, of_equals_holds_the_first) {
    const std::vector<CostAndError> ways{{1.0, 0.2}, {1.0, 0.2}};
    EXPECT_EQ(pareto_frontier(ways), Indices{0});
}

TEST(Frontier, of_random_ways_is_beaten_by_none_and_beats_all_others) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> figure(0.0, 1.0);
    std::vector<CostAndError> ways(200);
    for (CostAndError& way : ways) way = {figure(random), figure(random)};
    const Indices frontier = pareto_frontier(ways);
    ASSERT_FALSE(frontier.empty());
    for (std::size_t k = 0; k < ways.size(); ++k) {
        bool beaten = false;
        for (const CostAndError& other : ways)
            beaten = beaten || (other.cost < ways[k].cost && other.error < ways[k].error);
        const bool is_on_it = std::find(frontier.begin(), frontier.end(), k) != frontier.end();
        EXPECT_EQ(is_on_it, !beaten) << k;
    }
}

}  // namespace
}  // namespace hanei
