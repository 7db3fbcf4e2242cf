#include "app/desktop.h"
#include "engine/base/stoppable.h"
#include "engine/edit/edit.h"
#include "engine/project/gltf_writer.h"
#include "engine/project/json_value.h"
#include "ui/panels/state_text.h"
#include "ui/window/driver.h"

#include <atomic>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <numbers>
#include <thread>

namespace hanei {
namespace {

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

namespace fs = std::filesystem;

/// A desk that waits for no file, and files that take as long as a test likes.
class SlowFiles : public testing::Test {
protected:
    SlowFiles() : folder(fs::path(testing::TempDir()) / "hanei slow files" / name_of_test()) {
        fs::remove_all(folder);
        fs::create_directories(folder);
        Scene other = empty_room();
        other.title = "the other";
        EXPECT_FALSE(project_door().save({other, {}}, folder / "other.hanei"));
    }
    ~SlowFiles() override { lets_go = true; }
    static std::string name_of_test() { return testing::UnitTest::GetInstance()->current_test_info()->name(); }
    Driver::Setup setup() {
        Driver::Setup made{{with_panel_luminaire(empty_room()).scene, {}}, {}, project_door()};
        made.patience = 0.0;
        return made;
    }
    Driver::Setup held() {
        Driver::Setup made = setup();
        made.door.open = [this, open = made.door.open](const fs::path& file) {
            while (!lets_go) {
                stop_if_wished();
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
            }
            return open(file);
        };
        return made;
    }
    static std::string state(const Driver& driver, const std::string& name) {
        return state_of(driver.workbench())[name];
    }
    static void drop(Driver& driver, const fs::path& file) {
        const ScreenRect view = *driver.workbench().widgets().find("view");
        driver.drop({file}, view.x(), view.y());
    }
    static bool wait_idle(Driver& driver) {
        return driver.wait_until([&] { return driver.workbench().widgets().find("file.progress") == nullptr; }, 60.0);
    }

    fs::path folder;
    std::atomic<bool> lets_go = false;
};

TEST_F(SlowFiles, leave_the_window_alive_and_open_when_they_are_read) {
    Driver driver(held());
    drop(driver, folder / "other.hanei");
    EXPECT_NE(driver.workbench().widgets().find("file.progress"), nullptr);
    EXPECT_DONE(driver.click("tree.Panel 1"));
    EXPECT_EQ(state(driver, "selected"), "Panel 1") << "the window goes on";
    EXPECT_EQ(state(driver, "title"), "New room");
    lets_go = true;
    ASSERT_TRUE(wait_idle(driver));
    EXPECT_EQ(state(driver, "title"), "other");
    EXPECT_EQ(driver.workbench().document().shown()->title, "the other");
}

TEST_F(SlowFiles, that_are_cancelled_leave_everything_as_it_was) {
    Driver driver(held());
    const SceneSnapshot before = driver.workbench().document().shown();
    drop(driver, folder / "other.hanei");
    EXPECT_DONE(driver.click("file.cancel"));
    ASSERT_TRUE(wait_idle(driver));
    lets_go = true;
    driver.frames(5);
    EXPECT_EQ(driver.workbench().document().shown(), before);
    EXPECT_EQ(state(driver, "messages"), "0");
}

TEST_F(SlowFiles, take_the_place_of_no_change_made_meanwhile_without_asking) {
    Driver driver(held());
    drop(driver, folder / "other.hanei");
    EXPECT_DONE(driver.click("tree.Panel 1"));
    EXPECT_DONE(driver.press("Right"));
    const SceneSnapshot changed = driver.workbench().document().shown();
    lets_go = true;
    ASSERT_TRUE(driver.wait_until([&] { return state(driver, "dialog") == "unsaved"; }, 60.0));
    EXPECT_EQ(driver.workbench().document().shown(), changed);
    EXPECT_DONE(driver.click("unsaved.discard"));
    EXPECT_EQ(state(driver, "title"), "other");
}

TEST_F(SlowFiles, projects_of_thousands_of_luminaires_open_in_the_background) {
    Scene many = empty_room();
    const Scene one = with_panel_luminaire(many).scene;
    for (int k = 0; k < 3000; ++k) {
        Luminaire luminaire = one.luminaires.front();
        luminaire.id = many.new_id();
        luminaire.name = fmt::format("L{}", k);
        luminaire.group = {};
        many.luminaires.push_back(luminaire);
    }
    many.materials = one.materials;
    many.control_groups = one.control_groups;
    ASSERT_FALSE(project_door().save({many, {}}, folder / "many.hanei"));
    Driver driver(setup());
    drop(driver, folder / "many.hanei");
    ASSERT_TRUE(driver.wait_until([&] { return state(driver, "title") == "many"; }, 60.0));
    EXPECT_EQ(state(driver, "luminaires"), "3000");
}

/// A ball with bulges, of about this many triangles.
fs::path ball(const fs::path& file, int triangles) {
    const int rings = static_cast<int>(std::sqrt(triangles / 4.0)), around = 2 * rings;
    std::vector<Vec3> places;
    std::vector<std::uint32_t> corners;
    for (int i = 0; i <= rings; ++i)
        for (int k = 0; k < around; ++k) {
            const double t = std::numbers::pi * i / rings, p = 2.0 * std::numbers::pi * k / around;
            const double r = 1.0 + 0.1 * std::sin(5.0 * p) * std::sin(4.0 * t);
            places.push_back({r * std::sin(t) * std::cos(p), 1.2 + r * std::cos(t), r * std::sin(t) * std::sin(p)});
            if (i == rings) continue;
            const auto a = static_cast<std::uint32_t>(i * around + k);
            const auto b = static_cast<std::uint32_t>(i * around + (k + 1) % around);
            const auto down = static_cast<std::uint32_t>(around);
            if (i > 0) corners.insert(corners.end(), {a, b, a + down});
            if (i + 1 < rings) corners.insert(corners.end(), {b, b + down, a + down});
        }
    Diagnostics none;
    GltfWriter writer("test");
    const int positions = writer.add_places(places), indices = writer.add_indices(corners);
    writer.add("meshes",
               *parse_json(fmt::format(R"({{"primitives": [{{"attributes": {{"POSITION": {}}}, "indices": {}}}]}})",
                                       positions, indices),
                           "", none));
    writer.add("nodes", *parse_json(R"({"mesh": 0})", "", none));
    writer.add("scenes", *parse_json(R"({"nodes": [0]})", "", none));
    std::ofstream(file, std::ios::binary) << writer.binary();
    return file;
}

TEST_F(SlowFiles, models_of_two_hundred_thousand_triangles_can_be_cancelled) {
    Driver driver(setup());
    const SceneSnapshot before = driver.workbench().document().shown();
    drop(driver, ball(folder / "ball.glb", 200'000));
    ASSERT_NE(driver.workbench().widgets().find("file.progress"), nullptr);
    EXPECT_DONE(driver.click("tree.Panel 1"));
    EXPECT_DONE(driver.click("file.cancel"));
    driver.frames(5);
    EXPECT_EQ(driver.workbench().widgets().find("file.progress"), nullptr);
    EXPECT_EQ(driver.workbench().document().shown(), before);
    EXPECT_EQ(state(driver, "model"), "");
}

TEST_F(SlowFiles, models_are_asked_about_when_they_are_read_and_read_anew_behind_the_question) {
    Driver driver(setup());
    drop(driver, ball(folder / "ball.glb", 100));
    ASSERT_TRUE(driver.wait_until([&] { return !state(driver, "model").empty(); }, 60.0));
    EXPECT_NE(state(driver, "model").substr(0, 1), "0");
    EXPECT_DONE(driver.click("import.unit"));
    EXPECT_DONE(driver.click("import.unit.Centimetres"));
    ASSERT_TRUE(driver.wait_until([&] { return state(driver, "model").substr(0, 1) == "0"; }, 60.0));
    EXPECT_DONE(driver.click("import.ok"));
    EXPECT_EQ(state(driver, "furniture"), "1");
}

TEST_F(SlowFiles, folders_of_luminaire_files_hang_with_progress) {
    for (const char* const name : {"a.ies", "b.ies", "c.ies"})
        fs::copy(fs::path(HANEI_SOURCE) / "assets/photometry/downlight.ies", folder / name);
    Driver driver(setup());
    drop(driver, folder);
    ASSERT_TRUE(driver.wait_until([&] { return state(driver, "luminaires") == "4"; }, 60.0));
    EXPECT_EQ(state(driver, "undo depth"), "1");
}

TEST_F(SlowFiles, pictures_are_packed_beside_the_frames) {
    Driver driver(setup());
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_DONE(driver.press("Ctrl+E"));
    EXPECT_DONE(driver.click("export.folder"));
    driver.type(folder.string());
    EXPECT_DONE(driver.press("Enter"));
    EXPECT_DONE(driver.click("export.name"));
    driver.type("a.png");
    EXPECT_DONE(driver.press("Enter"));
    EXPECT_DONE(driver.click("export.accept"));
    ASSERT_TRUE(driver.wait_until([&] { return state(driver, "message") == "Exported a.png"; }, 60.0));
    EXPECT_TRUE(fs::exists(folder / "a.png"));
}

}  // namespace
}  // namespace hanei
