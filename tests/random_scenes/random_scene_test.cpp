/// The generator of scenes that nobody would draw.
#include "tests/random_scene.h"

#include "engine/scene/scene_check.h"

#include <gtest/gtest.h>
#include <set>

namespace hanei {
namespace {

TEST(RandomScenes, are_the_same_for_the_same_seed_and_fit_to_be_solved) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const Scene scene = test::random_scene(seed);
        EXPECT_EQ(scene, test::random_scene(seed)) << seed;
        EXPECT_FALSE(has_errors(check_scene(scene))) << seed;
    }
}

TEST(RandomScenes, have_every_kind_of_opening_with_and_without_a_room) {
    std::set<std::size_t> openings;
    std::set<bool> rooms;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const Scene scene = test::random_scene(seed);
        rooms.insert(scene.room.has_value());
        for (const Luminaire& luminaire : scene.luminaires) openings.insert(luminaire.opening.index());
    }
    EXPECT_EQ(openings.size(), std::variant_size_v<Opening>);
    EXPECT_EQ(rooms.size(), 2U);
}

}  // namespace
}  // namespace hanei
