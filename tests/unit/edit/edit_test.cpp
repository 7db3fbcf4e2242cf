#include "engine/edit/edit.h"

#include "engine/edit/excerpt.h"
#include "engine/scene/scene_check.h"

#include <array>
#include <gtest/gtest.h>

namespace hanei {
namespace {

TEST(EmptyRoom, is_a_room_without_faults) {
    for (const Diagnostic& finding : check_scene(empty_room())) {
        EXPECT_NE(finding.severity, Severity::error) << to_text(finding);
    }
}

TEST(NewObjects, all_stand_in_the_room_without_faults) {
    using Make = Added (*)(Scene);
    for (const Make make : {Make(with_point_luminaire), Make(with_line_luminaire), Make(with_panel_luminaire),
                            Make(with_box), Make(with_grid), Make(with_calculation_point)}) {
        const Added added = make(empty_room());
        EXPECT_NE(kind_of(added.scene, added.object), ObjectKind::none);
        const auto place = place_of(added.scene, added.object);
        ASSERT_TRUE(place);
        EXPECT_GT(place->x, 0.0);
        EXPECT_LT(place->x, 6.0);
        for (const Diagnostic& finding : check_scene(added.scene)) {
            EXPECT_EQ(finding.severity, Severity::note) << to_text(finding);
        }
    }
}

TEST(Editing, moves_only_the_object_it_is_about) {
    Added first = with_panel_luminaire(empty_room());
    const Added second = with_panel_luminaire(first.scene);
    const Scene scene = moved(second.scene, first.object, {0.5, -0.25, 0.0});
    EXPECT_EQ(*place_of(scene, first.object), *place_of(second.scene, first.object) + Vec3(0.5, -0.25, 0.0));
    EXPECT_EQ(*place_of(scene, second.object), *place_of(second.scene, second.object));
}

TEST(Editing, a_copy_has_an_id_of_its_own_and_stands_beside) {
    const Added box = with_box(empty_room());
    const AddedSeveral copy = duplicated(box.scene, std::array{box.object});
    ASSERT_EQ(copy.objects.size(), 1U);
    EXPECT_NE(copy.objects.front(), box.object);
    EXPECT_EQ(copy.scene.furniture.size(), 2U);
    const double beside = place_of(copy.scene, copy.objects.front())->x - place_of(copy.scene, box.object)->x;
    EXPECT_NEAR(beside, 1.2, 1e-12);  // its own width, but for the rounding of a sum
    EXPECT_EQ(removed(copy.scene, copy.objects).furniture, box.scene.furniture);
}

TEST(Editing, materials_and_the_room_cannot_be_removed) {
    EXPECT_FALSE(can_remove(ObjectKind::room));
    EXPECT_FALSE(can_remove(ObjectKind::material));
    EXPECT_TRUE(can_remove(ObjectKind::luminaire));
}

}  // namespace
}  // namespace hanei
