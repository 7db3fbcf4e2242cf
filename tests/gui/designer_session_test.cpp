#include "app/desktop.h"
#include "engine/edit/edit.h"
#include "ui/window/driver.h"
#include "ui/window/script.h"

#include <gtest/gtest.h>
#include <sstream>

namespace hanei {
namespace {

/// From nothing to a project that is handed over: a room with a door and a window, ten pieces of
/// furniture, a field of measured luminaires, a group of them, two light scenes, their difference, a
/// pin, a picture, and the file.
constexpr std::string_view session = R"(key Ctrl+Shift+N
wait 3
click new.length
type 9
key Enter
click new.width
type 6.4
key Enter
click new.ok
wait 10
click tree.Room
wait 2
click room.add.door
wait 2
click tree.Room
wait 2
click room.add.window
wait 2
click tab.Furniture
wait 2
click library.desk
key Ctrl+Shift+D
wait 2
click array.rows
type 2
key Enter
click copies.ok
wait 3
click library.conference-table
wait 2
click library.chair
wait 2
click library.reception
wait 2
click library.desk-drawers
wait 3
drop LUMINAIRE 500 300
wait 5
click menu.Light
click light.field
wait 5
click tab.Properties
wait 2
key Ctrl+A
click menu.Add
click add.grid
wait 3
wait converged
click tab.Objects
wait 2
click "tree.Recessed panel 600 x 600, microprismatic 1"
click "tree.Recessed panel 600 x 600, microprismatic 4" with Shift
click tab.Light
wait 2
click light.new_group
wait 3
click light.keep
wait 3
key Alt+A
wait 2
click "light.off.Group 1"
wait 2
click light.keep
wait converged
key Alt+B
wait 2
key J
wait 5
key J
key Ctrl+F1
wait converged
click view
key X
wait converged
key Ctrl+E
wait 3
click export.accept
wait 5
key Ctrl+S
wait 3
click browser.name
key Ctrl+A
type session.hanei
click browser.accept
wait 5
expect saved true
)";

TEST(ADesigner, makes_lights_compares_and_saves_a_room_and_finds_it_again_as_it_was) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "hanei session";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder);
    std::string text(session);
    const std::string luminaire = "LUMINAIRE";
    text.replace(text.find(luminaire), luminaire.size(),
                 std::string("\"") + HANEI_SOURCE + "/assets/photometry/panel-600-microprismatic.ies\"");
    Driver driver({{empty_room(), {}}, {}, project_door()});
    std::ostringstream out;
    const auto fault = play_script(text, "session", driver, out);
    std::filesystem::current_path(before);
    ASSERT_FALSE(fault) << to_text(*fault);

    const Scene& made = *driver.workbench().document().shown();
    EXPECT_EQ(made.furniture.size(), 10U);
    EXPECT_EQ(made.luminaires.size(), 12U);
    EXPECT_EQ(made.arrangements.size(), 1U);
    EXPECT_EQ(made.control_groups.size(), 1U);
    EXPECT_EQ(made.light_scenes.size(), 2U);
    EXPECT_EQ(made.points.size(), 1U);
    EXPECT_EQ(made.room->sub_areas.size(), 2U);
    const auto opened = project_door().open(folder / "session.hanei");
    ASSERT_TRUE(opened.content);
    EXPECT_TRUE(opened.content->scene == made);
    EXPECT_TRUE(opened.content->settings == driver.workbench().document().settings());
    int pictures = 0;
    for (const auto& file : std::filesystem::directory_iterator(folder))
        pictures += file.path().extension() == ".png" ? 1 : 0;
    EXPECT_EQ(pictures, 1);
}

}  // namespace
}  // namespace hanei
