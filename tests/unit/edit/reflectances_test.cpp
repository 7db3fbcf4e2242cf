#include "engine/edit/reflectances.h"

#include "engine/edit/edit.h"
#include "engine/edit/furniture_edits.h"
#include "engine/edit/material_palette.h"
#include "engine/scene/colour.h"
#include "engine/scene/scene_check.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

TEST(Reflectances, of_every_preset_are_what_its_name_says) {
    for (const ReflectancePreset& preset : reflectance_presets()) {
        EXPECT_EQ(reflectances_of(preset.name), preset.values) << preset.name;
        const Scene scene = with_reflectances(empty_room(), preset.values);
        EXPECT_EQ(reflectances_of(scene), preset.values) << preset.name;
        EXPECT_EQ(scene.materials.size(), 3U);  // the room's own are changed
    }
}

TEST(Reflectances, in_words_are_three_percentages) {
    EXPECT_EQ(reflectances_of("75/45.5/0"), (Reflectances{0.75, 0.455, 0.0}));
    for (const char* text : {"", "70/50", "70/50/20/1", "70/50/120", "-1/50/20", "a/b/c", "70 50 20"})
        EXPECT_FALSE(reflectances_of(std::string_view(text))) << text;
}

TEST(Reflectances, leave_what_else_is_covered_with_the_material_alone) {
    Scene scene = with_box(empty_room()).scene;
    const ObjectId floor = scene.room->floor_material;
    scene.furniture[0].parts[0].material = floor;
    const Scene lit = with_reflectances(scene, {0.8, 0.5, 0.3});
    EXPECT_EQ(lit.furniture[0].parts[0].material, floor);
    EXPECT_NE(lit.room->floor_material, floor);
    EXPECT_EQ(users_of_material(lit, floor), 1);
    EXPECT_EQ(reflectances_of(lit), (Reflectances{0.8, 0.5, 0.3}));
    EXPECT_EQ(with_reflectances({}, {0.8, 0.5, 0.3}), Scene{});
}

TEST(AMaterial, is_replaced_wherever_it_was_and_unused_ones_go) {
    Scene scene = with_furniture(empty_room(), {"desk", {}}).scene;
    const ObjectId wood = material_named(scene, "Wood, light");
    const ObjectId dark = material_named(scene, "Wood, dark");
    EXPECT_EQ(users_of_material(scene, wood), 1);
    scene = with_material_replaced(std::move(scene), wood, dark);
    EXPECT_EQ(users_of_material(scene, wood), 0);
    EXPECT_EQ(users_of_material(scene, dark), 1);
    const std::size_t before = scene.materials.size();
    scene = without_unused_materials(std::move(scene));
    EXPECT_EQ(scene.materials.size(), before - 1);
    for (const Diagnostic& finding : check_scene(scene))
        EXPECT_NE(finding.severity, Severity::error) << to_text(finding);
}

TEST(ThePalette, holds_materials_that_can_be_grey_or_coloured) {
    for (const PaletteEntry& entry : material_palette()) {
        Scene scene;
        for (const bool coloured : {false, true}) {
            Material material = material_of(entry, coloured);
            material.id = scene.new_id();
            EXPECT_EQ(material.reflectance, entry.reflectance);
            scene.materials.push_back(material);
        }
        EXPECT_EQ(scene.materials[0].tint, Vec3(1.0));
        EXPECT_TRUE(check_scene(scene).empty()) << entry.name;
    }
}

}  // namespace
}  // namespace hanei
