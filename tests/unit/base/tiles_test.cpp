#include "engine/base/tiles.h"

#include <atomic>
#include <gtest/gtest.h>
#include <stdexcept>
#include <thread>
#include <vector>

namespace hanei {
namespace {

TEST(Tiles, every_item_is_visited_once_on_any_number_of_threads) {
    for (const int threads : {1, 2, 7}) {
        std::vector<int> visits(1003, 0);
        EXPECT_TRUE(for_each_tile(visits.size(), 16, {threads, {}, nullptr}, [&](std::size_t begin, std::size_t end) {
            EXPECT_LE(end - begin, 16U);
            for (std::size_t k = begin; k < end; ++k) ++visits[k];
        }));
        EXPECT_EQ(visits, std::vector<int>(1003, 1));
    }
}

TEST(Tiles, no_items_are_finished_at_once) {
    EXPECT_TRUE(for_each_tile(0, 8, {}, [](std::size_t, std::size_t) { FAIL(); }));
}

TEST(Tiles, a_stop_leaves_the_rest_undone) {
    std::stop_source stop;
    std::size_t done = 0;
    const bool finished = for_each_tile(100, 10, {1, stop.get_token(), nullptr}, [&](std::size_t, std::size_t) {
        if (++done == 3) stop.request_stop();
    });
    EXPECT_FALSE(finished);
    EXPECT_EQ(done, 3U);
}

TEST(Tiles, progress_runs_to_one) {
    Progress progress;
    progress.enter(Stage::direct);
    EXPECT_EQ(progress.fraction(), 0.0F);
    for_each_tile(50, 7, {2, {}, &progress}, [](std::size_t, std::size_t) {});
    EXPECT_EQ(progress.fraction(), 1.0F);
    EXPECT_EQ(progress.stage(), Stage::direct);
}

TEST(Tiles, within_tiles_are_all_visited) {
    std::vector<int> visits(20 * 30, 0);
    for_each_tile(20, 1, {3, {}, nullptr}, [&](std::size_t outer, std::size_t) {
        for_each_tile(30, 4, {3, {}, nullptr}, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) ++visits[outer * 30 + k];
        });
    });
    EXPECT_EQ(visits, std::vector<int>(20 * 30, 1));
}

TEST(Tiles, of_several_callers_at_once_are_all_visited) {
    std::vector<std::vector<int>> visits(4, std::vector<int>(500, 0));
    {
        std::vector<std::jthread> callers;
        for (std::vector<int>& mine : visits) {
            callers.emplace_back([&mine] {
                for (int turn = 0; turn < 50; ++turn) {
                    for_each_tile(mine.size(), 8, {3, {}, nullptr}, [&](std::size_t begin, std::size_t end) {
                        for (std::size_t k = begin; k < end; ++k) ++mine[k];
                    });
                }
            });
        }
    }
    for (const std::vector<int>& mine : visits) EXPECT_EQ(mine, std::vector<int>(500, 50));
}

TEST(Tiles, an_exception_reaches_the_caller) {
    EXPECT_THROW(for_each_tile(100, 10, {3, {}, nullptr},
                               [](std::size_t begin, std::size_t) {
                                   if (begin == 40) throw std::runtime_error("no memory");
                               }),
                 std::runtime_error);
}

}  // namespace
}  // namespace hanei
