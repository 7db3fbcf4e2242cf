#include "ui/panels/snapshots.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

/// A solution that is told from others by its title alone.
SolutionSnapshot titled(const std::string& title) {
    auto scene = std::make_shared<Scene>();
    scene->title = title;
    auto solution = std::make_shared<Solution>();
    solution->scene = std::move(scene);
    solution->mesh = std::make_shared<const Mesh>();
    solution->display = std::make_shared<const DisplayMesh>();
    return solution;
}

std::string shown(Snapshots& snapshots, const SolutionSnapshot& present, bool flipped) {
    const SolutionSnapshot kept = snapshots.follow(present, flipped);
    return kept ? kept->scene->title : "present";
}

TEST(KeptStates, flip_to_a_while_the_key_is_held_and_back) {
    Snapshots snapshots;
    const SolutionSnapshot present = titled("present");
    EXPECT_EQ(shown(snapshots, present, true), "present") << "nothing is kept";
    snapshots.keep_as_a(titled("day"), {});
    EXPECT_EQ(shown(snapshots, present, false), "present");
    EXPECT_EQ(shown(snapshots, present, true), "day");
    snapshots.show = Snapshots::Show::a;
    EXPECT_EQ(shown(snapshots, present, true), "present") << "the other one, while no B is kept";
    snapshots.keep_as_b(titled("night"), {});
    EXPECT_EQ(shown(snapshots, present, true), "night");
    EXPECT_EQ(shown(snapshots, present, false), "day");
}

TEST(KeptStates, keep_their_places_when_another_is_removed) {
    Snapshots snapshots;
    for (const char* title : {"first", "second", "third"}) snapshots.keep_as_a(titled(title), {});
    snapshots.keep_as_b(titled("fourth"), {});
    ASSERT_EQ(snapshots.list().size(), 4U);
    snapshots.remove(0);
    EXPECT_EQ(snapshots.first()->scene->title, "third");
    EXPECT_EQ(snapshots.second(nullptr)->scene->title, "fourth");
    snapshots.remove(*snapshots.a());
    EXPECT_FALSE(snapshots.a());
    snapshots.show = Snapshots::Show::a;
    EXPECT_EQ(shown(snapshots, titled("present"), false), "present") << "what was removed is not shown";
    snapshots.remove(99);
    EXPECT_EQ(snapshots.list().size(), 2U);
}

TEST(KeptStates, are_subtracted_from_the_present_one_while_no_b_is_kept) {
    Snapshots snapshots;
    snapshots.show = Snapshots::Show::difference;
    EXPECT_EQ(shown(snapshots, titled("present"), false), "present");
    EXPECT_FALSE(snapshots.shows_difference());
    snapshots.keep_as_a(titled("before"), {});
    const SolutionSnapshot present = titled("after");
    EXPECT_EQ(shown(snapshots, present, false), "after");
    EXPECT_TRUE(snapshots.shows_difference());
    EXPECT_GE(snapshots.range_of(LightPart::total), 1.0) << "a scale even where nothing differs";
    EXPECT_EQ(snapshots.follow(present, false), snapshots.follow(present, false)) << "worked out once";
    snapshots.forget();
    EXPECT_TRUE(snapshots.list().empty());
}

}  // namespace
}  // namespace hanei
