#include "ui/panels/properties.h"

#include "ui/panels/edit.h"
#include "ui/panels/key.h"
#include "ui/panels/style.h"

#include <gtest/gtest.h>
#include <imgui.h>

namespace hanei {
namespace {

/// A panel in a bare ImGui context: no window, no OpenGL, no display.
class APanel : public testing::Test {
protected:
    APanel() : context(ImGui::CreateContext()) {
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.ConfigDragClickToInputText = true;
        io.DisplaySize = {400.0F, 800.0F};
        io.KeyMap[ImGuiKey_Enter] = static_cast<int>(Key::enter);
        io.KeyMap[ImGuiKey_Escape] = static_cast<int>(Key::escape);
        style::apply(1.0F);
        unsigned char* pixels = nullptr;
        int width = 0;
        int height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    }
    ~APanel() override { ImGui::DestroyContext(context); }

    /// One frame; takes the scene the panel would rather have.
    bool frame() {
        ImGuiIO& io = ImGui::GetIO();
        io.DeltaTime = 1.0F / 60.0F;
        ImGui::NewFrame();
        widgets.begin_frame();
        form.begin_frame();
        ImGui::SetNextWindowPos({0.0F, 0.0F});
        ImGui::SetNextWindowSize({400.0F, 800.0F});
        ImGui::Begin("panel");
        form.begin("properties");
        const std::optional<Scene> wished = object_panel(scene, selected, form);
        form.end();
        ImGui::End();
        ImGui::EndFrame();
        if (wished) scene = *wished;
        return wished.has_value();
    }
    int frames(int count) {
        int changes = 0;
        for (int k = 0; k < count; ++k) changes += frame() ? 1 : 0;
        return changes;
    }
    void point_at(const std::string& widget) {
        const ScreenRect* rect = widgets.find(widget);
        ASSERT_NE(rect, nullptr) << widget;
        ImGui::GetIO().MousePos = {rect->x(), rect->y()};
    }
    int hold(bool down) {
        ImGui::GetIO().MouseDown[0] = down;
        return frames(2);
    }
    int key(Key key) {
        ImGui::GetIO().KeysDown[static_cast<int>(key)] = true;
        int changes = frames(1);
        ImGui::GetIO().KeysDown[static_cast<int>(key)] = false;
        changes += frames(1);
        return changes;
    }
    int type_into(const std::string& widget, const char* text) {
        point_at(widget);
        int changes = hold(true) + hold(false) + frames(2);
        for (const char* letter = text; *letter != '\0'; ++letter) {
            ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(*letter));
            changes += frames(1);
        }
        return changes;
    }
    const Luminaire& lamp() const { return scene.luminaires.back(); }
    void show(const Added& added) {
        scene = added.scene;
        selected = added.object;
        frames(3);
    }

    ImGuiContext* context;
    WidgetRegistry widgets;
    Form form{widgets};
    Scene scene = empty_room();
    ObjectId selected;
};

TEST_F(APanel, changes_nothing_while_nobody_touches_it) {
    show(with_panel_luminaire(scene));
    EXPECT_EQ(frames(5), 0);
}

TEST_F(APanel, takes_a_typed_figure_when_enter_is_pressed_and_not_before) {
    show(with_panel_luminaire(scene));
    const double before = lamp().position.x;
    EXPECT_EQ(type_into("luminaire.x", "1.25"), 0);
    EXPECT_EQ(lamp().position.x, before);
    EXPECT_EQ(key(Key::enter), 1);
    EXPECT_EQ(lamp().position.x, 1.25);
}

TEST_F(APanel, takes_a_typed_figure_when_something_else_is_clicked) {
    show(with_panel_luminaire(scene));
    type_into("luminaire.flux", "4200");
    point_at("luminaire.name");  // drawn before it: it takes the click first
    EXPECT_EQ(hold(true) + hold(false), 1);
    EXPECT_EQ(std::get<LuminousFlux>(lamp().output).value, 4200.0);
}

TEST_F(APanel, forgets_a_typed_figure_on_escape) {
    show(with_panel_luminaire(scene));
    const Scene before = scene;
    type_into("luminaire.x", "5");
    EXPECT_EQ(key(Key::escape) + frames(2), 0);
    EXPECT_EQ(scene, before);
}

TEST_F(APanel, holds_a_typed_figure_to_what_is_possible) {
    show(with_panel_luminaire(scene));
    type_into("luminaire.dimming", "250");
    key(Key::enter);
    EXPECT_EQ(lamp().dimming, 1.0);
}

TEST_F(APanel, slides_a_figure_that_is_dragged) {
    show(with_panel_luminaire(scene));
    const double before = lamp().position.y;
    point_at("luminaire.y");
    hold(true);
    ImGui::GetIO().MousePos.x += 40.0F;
    EXPECT_GT(frames(2), 0);
    hold(false);
    EXPECT_NEAR(lamp().position.y, before + 0.4, 0.05);  // 0.01 m a pixel, less the first pixels that mean a click
}

TEST_F(APanel, dims_all_luminaires_of_a_group_together) {
    Added first = with_panel_luminaire(scene);
    Added second = with_panel_luminaire(first.scene);
    for (Luminaire& luminaire : second.scene.luminaires) luminaire.group = "rows";
    show(second);
    type_into("luminaire.dimming", "40");
    key(Key::enter);
    EXPECT_EQ(scene.luminaires[0].dimming, 0.4);
    EXPECT_EQ(scene.luminaires[1].dimming, 0.4);
}

TEST_F(APanel, renames_when_the_name_is_finished) {
    show(with_box(scene));
    type_into("furniture.name", "Sideboard");
    EXPECT_EQ(scene.furniture[0].name, "Box 1");
    key(Key::enter);
    EXPECT_EQ(scene.furniture[0].name, "Sideboard");
}

TEST_F(APanel, shows_every_kind_of_object) {
    for (const auto make : {with_point_luminaire, with_line_luminaire, with_panel_luminaire, with_box, with_grid,
                            with_calculation_point}) {
        show(make(scene));
        EXPECT_EQ(frames(2), 0) << name_of(kind_of(scene, selected));
    }
    for (const ObjectId id : {scene.room->id, scene.materials.front().id, ObjectId{}}) {
        selected = id;
        EXPECT_EQ(frames(2), 0) << name_of(kind_of(scene, selected));
    }
}

}  // namespace
}  // namespace hanei
