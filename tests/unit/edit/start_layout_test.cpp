#include "engine/edit/start_layout.h"

#include "engine/edit/arrangements.h"
#include "engine/scene/scene_check.h"
#include "tests/unit/edit/luminaire_scenes.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

TEST(StartLayout, hangs_the_field_that_the_lumen_method_asks_for_above_a_working_plane) {
    const Added lamp = test::hung(test::lobe(1.0));
    LumenWish wish;
    wish.mounting = {Mounting::pendant, 0.4};
    const LumenAnswer answer = lumen_method(lamp.scene, lamp.scene.luminaires[0], wish);
    const Added made = with_start_layout(lamp.scene, lamp.object, wish, answer);
    EXPECT_EQ(static_cast<int>(made.scene.luminaires.size()), answer.count());
    for (const Luminaire& luminaire : made.scene.luminaires) EXPECT_NEAR(luminaire.position.z, 2.4, 1e-9);
    ASSERT_EQ(made.scene.grids.size(), 1U);
    EXPECT_EQ(working_plane_of(made.scene), made.scene.grids[0].id);
    EXPECT_EQ(made.scene.grids[0].corner, Vec3(0.5, 0.5, 0.75));
    EXPECT_TRUE(check_scene(made.scene).empty());
}

TEST(StartLayout, asked_for_again_changes_the_same_field) {
    const Added lamp = test::hung(test::lobe(1.0));
    LumenWish wish;
    const Added first =
        with_start_layout(lamp.scene, lamp.object, wish, lumen_method(lamp.scene, lamp.scene.luminaires[0], wish));
    wish.target = 1000.0;
    const LumenAnswer more = lumen_method(first.scene, first.scene.luminaires[0], wish);
    const Added second = with_start_layout(first.scene, first.scene.luminaires[0].id, wish, more);
    EXPECT_EQ(second.object, first.object);
    EXPECT_EQ(second.scene.arrangements.size(), 1U);
    EXPECT_EQ(second.scene.grids.size(), 1U);
    EXPECT_EQ(static_cast<int>(second.scene.luminaires.size()), more.count());
}

TEST(StartLayout, is_corrected_by_dimming_all_of_it_and_nothing_else) {
    Added lamp = test::hung(test::lobe(1.0));
    lamp.scene = with_point_luminaire(std::move(lamp.scene)).scene;
    Added made = arranged(lamp.scene, lamp.object, field_over_room(lamp.scene, 2.5, 2, 2));
    const Scene scene = with_output_scaled(made.scene, made.object, 0.8);
    for (const Luminaire& luminaire : scene.luminaires)
        EXPECT_EQ(luminaire.dimming, arrangement_of(scene, luminaire.id) ? 0.8 : 1.0);
    EXPECT_EQ(with_output_scaled(made.scene, made.object, 3.0), made.scene) << "there is no more than full output";
}

}  // namespace
}  // namespace hanei
