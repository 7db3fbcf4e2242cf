#include "app/desktop.h"
#include "engine/edit/edit.h"
#include "engine/project/gltf_export.h"
#include "engine/project/gltf_import.h"
#include "ui/panels/state_text.h"
#include "ui/window/driver.h"

#include <filesystem>
#include <gtest/gtest.h>

namespace hanei {
namespace {

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

std::filesystem::path model(const std::string& name) {
    return std::filesystem::path(HANEI_SOURCE) / "tests/golden/gltf" / name;
}

/// An empty room of 6 m x 4 m.
class ModelsDropped : public testing::Test {
protected:
    ModelsDropped() : driver({{empty_room(), {}}, {}, project_door()}), before(scene()) {
        const ScreenRect view = *driver.workbench().widgets().find("view");
        x = view.x();
        y = view.y();
    }
    std::string state(const std::string& name) { return state_of(driver.workbench())[name]; }
    const SceneSnapshot& scene() const { return driver.workbench().document().shown(); }
    void drop(const std::string& name) { driver.drop({model(name)}, x, y); }

    Driver driver;
    SceneSnapshot before;
    float x = 0.0F, y = 0.0F;
};

TEST_F(ModelsDropped, are_shown_by_size_and_kind_before_they_are_taken_in_one_step) {
    drop("chair.gltf");
    EXPECT_EQ(state("model"), "0.40 x 0.40 x 0.86 m, 6 solids, 0 sheets, 0 luminaires");
    EXPECT_EQ(scene(), before);
    EXPECT_DONE(driver.click("import.ok"));
    ASSERT_EQ(scene()->furniture.size(), 1U);
    EXPECT_EQ(scene()->furniture[0].position.z, 0.0);
    EXPECT_EQ(driver.workbench().chosen(), scene()->furniture[0].id);
    EXPECT_EQ(state("undo"), "Import chair.gltf");
    EXPECT_EQ(state("undo depth"), "1");
    EXPECT_DONE(driver.press("Ctrl+Z"));
    EXPECT_EQ(scene(), before);
}

TEST_F(ModelsDropped, are_read_in_another_unit_when_asked) {
    drop("shelf_in_mm.gltf");
    EXPECT_EQ(state("model"), "940.00 x 300.00 x 1800.00 m, 6 solids, 0 sheets, 0 luminaires");
    EXPECT_DONE(driver.click("import.unit"));
    EXPECT_DONE(driver.click("import.unit.Millimetres"));
    EXPECT_EQ(state("model"), "0.94 x 0.30 x 1.80 m, 6 solids, 0 sheets, 0 luminaires");
    EXPECT_DONE(driver.click("import.cancel"));
    EXPECT_EQ(state("model"), "");
    EXPECT_EQ(scene(), before);
}

TEST_F(ModelsDropped, bring_their_room_in_place_of_all_that_was_there_or_beside_it) {
    drop("chair.gltf");
    EXPECT_DONE(driver.click("import.ok"));
    drop("office.gltf");
    EXPECT_DONE(driver.click("import.place"));
    EXPECT_DONE(driver.click("import.place.Beside what is there, but for the room"));
    EXPECT_DONE(driver.click("import.ok"));
    EXPECT_EQ(scene()->furniture.size(), 2U);
    EXPECT_DONE(driver.press("Ctrl+Z"));
    drop("office.gltf");
    EXPECT_DONE(driver.click("import.ok"));
    ASSERT_EQ(scene()->furniture.size(), 1U);
    EXPECT_EQ(scene()->furniture[0].name, "desk");
    ASSERT_TRUE(scene()->room.has_value());
    EXPECT_EQ(scene()->room->plan.size(), 6U);
    EXPECT_EQ(state("luminaires"), "3");
    EXPECT_EQ(state("undo depth"), "2");
}

TEST_F(ModelsDropped, of_a_room_that_was_exported_begin_a_new_project_equal_to_it) {
    const auto file = std::filesystem::path(testing::TempDir()) / "office to begin with.glb";
    const auto office = project_door().open(std::filesystem::path(HANEI_SOURCE) / "assets/rooms/office.hanei");
    ASSERT_TRUE(office.content.has_value());
    ASSERT_FALSE(write_gltf({office.content->scene, office.content->settings}, nullptr, file));
    driver.drop({file}, x, y);
    EXPECT_DONE(driver.click("import.place"));
    EXPECT_DONE(driver.click("import.place.As a new project"));
    EXPECT_DONE(driver.click("import.ok"));
    EXPECT_EQ(*scene(), office.content->scene);
    EXPECT_EQ(driver.workbench().document().settings(), office.content->settings);
    EXPECT_FALSE(driver.workbench().document().is_saved());
    EXPECT_TRUE(driver.workbench().document().file().empty());
    EXPECT_EQ(state("message"), "Imported office to begin with.glb as a new project");
}

TEST_F(ModelsDropped, that_begin_a_new_project_ask_about_work_that_is_not_saved) {
    drop("chair.gltf");
    EXPECT_DONE(driver.click("import.ok"));
    drop("office.gltf");
    EXPECT_DONE(driver.click("import.place"));
    EXPECT_DONE(driver.click("import.place.As a new project"));
    EXPECT_DONE(driver.click("import.ok"));
    EXPECT_EQ(state("dialog"), "unsaved");
    EXPECT_DONE(driver.click("unsaved.cancel"));
    ASSERT_EQ(scene()->furniture.size(), 1U);
    EXPECT_EQ(scene()->furniture[0].name, "chair");
}

TEST_F(ModelsDropped, that_are_faulty_are_refused_with_a_sentence) {
    const auto file = std::filesystem::path(testing::TempDir()) / "no model.glb";
    ASSERT_FALSE(project_door().save({empty_room(), {}}, file));
    driver.drop({file}, x, y);
    EXPECT_EQ(state("dialog"), "findings");
    EXPECT_EQ(scene(), before);
}

TEST_F(ModelsDropped, and_the_light_go_out_as_gltf_and_come_back) {
    drop("chair.gltf");
    EXPECT_DONE(driver.click("import.ok"));
    ASSERT_TRUE(driver.wait_settled());
    const auto file = std::filesystem::path(testing::TempDir()) / "out.glb";
    const auto& workbench = driver.workbench();
    ASSERT_FALSE(
        project_door().export_model(*workbench.study().solution(), workbench.viewport().state.options, file, {}));
    const GltfImport again = import_gltf(file, {});
    ASSERT_TRUE(again.scene.has_value());
    EXPECT_EQ(again.scene->room, scene()->room);
    EXPECT_EQ(again.solids, 6);
}

}  // namespace
}  // namespace hanei
