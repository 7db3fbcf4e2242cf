#include "ui/panels/properties.h"

#include "engine/edit/edit.h"
#include "engine/scene/colour.h"
#include "engine/scene/scene_check.h"
#include "ui/panels/key.h"
#include "ui/panels/style.h"
#include "ui/panels/units.h"

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
        style::apply(Theme::dark, 1.0F, Language::english);
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

TEST_F(APanel, dims_one_luminaire_of_a_group_by_its_own_dimmer) {
    Added first = with_panel_luminaire(scene);
    Added second = with_panel_luminaire(first.scene);
    second.scene.control_groups.push_back({second.scene.new_id(), "rows", 1.0, 0.0, {}});
    for (Luminaire& luminaire : second.scene.luminaires) luminaire.group = second.scene.control_groups.back().id;
    show(second);
    type_into("luminaire.dimming", "40");
    key(Key::enter);
    EXPECT_EQ(scene.luminaires[0].dimming, 1.0);
    EXPECT_EQ(scene.luminaires[1].dimming, 0.4);
}

TEST_F(APanel, renames_when_the_name_is_finished) {
    show(with_box(scene));
    type_into("furniture.name", "Sideboard");
    EXPECT_EQ(scene.furniture[0].name, "Box 1");
    key(Key::enter);
    EXPECT_EQ(scene.furniture[0].name, "Sideboard");
}

TEST_F(APanel, takes_a_colour_by_its_digits_and_keeps_the_reflectance) {
    selected = scene.materials.front().id;
    const double reflectance = scene.materials.front().reflectance;
    frames(3);
    EXPECT_EQ(type_into("material.colour.digits", "#C89060"), 0) << "not before it is finished";
    EXPECT_EQ(key(Key::enter), 1);
    const Material& painted = scene.materials.front();
    EXPECT_EQ(painted.reflectance, reflectance);
    EXPECT_EQ(painted.tint, tint_from_srgb(Vec3(0xC8, 0x90, 0x60) / 255.0, reflectance));
    EXPECT_FALSE(has_errors(check_scene(scene)));
    EXPECT_EQ(type_into("material.colour.digits", "reddish") + key(Key::enter), 0) << "no colour";
    frames(2);
    point_at("material.neutral");
    EXPECT_EQ(hold(true) + hold(false), 1);
    EXPECT_EQ(scene.materials.front().tint, Vec3(1.0));
    frames(2);
    EXPECT_EQ(widgets.find("material.neutral"), nullptr);
}

TEST_F(APanel, lets_a_deep_colour_be_no_lighter_than_its_band_that_reflects_most) {
    scene.materials.front().reflectance = 0.1;
    scene.materials.front().tint = tint_from_srgb({0.8, 0.2, 0.1}, 0.1);
    selected = scene.materials.front().id;
    frames(3);
    type_into("material.reflectance", "90");
    key(Key::enter);
    const Material& painted = scene.materials.front();
    EXPECT_NEAR(painted.reflectance * painted.tint.x, most_of_a_chosen_band, 1e-12);
    EXPECT_FALSE(has_errors(check_scene(scene)));
}

TEST_F(APanel, picks_a_colour_with_the_mouse) {
    selected = scene.materials.front().id;
    frames(3);
    point_at("material.colour");
    hold(true);
    hold(false);
    frames(2);
    const ScreenRect* picker = widgets.find("material.colour.picker");
    ASSERT_NE(picker, nullptr);
    ImGui::GetIO().MousePos = {picker->left + 0.6F * (picker->right - picker->left), picker->top + 20.0F};
    EXPECT_GT(hold(true), 0);
    hold(false);
    EXPECT_NE(scene.materials.front().tint, Vec3(1.0));
    EXPECT_FALSE(has_errors(check_scene(scene)));
}

TEST_F(APanel, gives_a_luminaire_a_usual_colour_temperature_or_any) {
    show(with_panel_luminaire(scene));
    const auto choose = [&](const char* entry) {
        point_at("luminaire.colour");
        hold(true);
        hold(false);
        frames(3);
        point_at(entry);
        const int changes = hold(true) + hold(false);
        frames(3);
        return changes;
    };
    EXPECT_EQ(widgets.find("luminaire.temperature"), nullptr) << "neutral light has none";
    EXPECT_EQ(choose("luminaire.colour.2700 K"), 1);
    EXPECT_EQ(lamp().colour_temperature, 2700.0);
    type_into("luminaire.temperature", "3200");
    key(Key::enter);
    EXPECT_EQ(lamp().colour_temperature, 3200.0);
    type_into("luminaire.temperature", "12");
    key(Key::enter);
    EXPECT_EQ(lamp().colour_temperature, lowest_colour_temperature);
    EXPECT_EQ(choose("luminaire.colour.Other"), 0) << "it is another already";
    EXPECT_EQ(choose("luminaire.colour.Neutral"), 1);
    EXPECT_EQ(lamp().colour_temperature, 0.0);
    EXPECT_EQ(choose("luminaire.colour.Other"), 1);
    EXPECT_EQ(lamp().colour_temperature, 3500.0);
}

TEST_F(APanel, gives_its_light_colour_to_all_luminaires_when_asked) {
    Added first = with_panel_luminaire(scene);
    Added second = with_point_luminaire(first.scene);
    show(second);
    EXPECT_EQ(widgets.find("luminaire.colour_all"), nullptr) << "all are alike";
    scene.luminaires.back().colour_temperature = 3000.0;
    frames(3);
    point_at("luminaire.colour_all");
    EXPECT_EQ(hold(true) + hold(false), 1);
    for (const Luminaire& luminaire : scene.luminaires) EXPECT_EQ(luminaire.colour_temperature, 3000.0);
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

TEST_F(APanel, calculates_what_is_typed_and_counts_its_units) {
    show(with_panel_luminaire(scene));
    type_into("luminaire.x", "2*0.6+0.05");
    key(Key::enter);
    EXPECT_NEAR(lamp().position.x, 1.25, 1e-12);
    type_into("luminaire.y", "150 cm");
    key(Key::enter);
    EXPECT_NEAR(lamp().position.y, 1.5, 1e-12);
    type_into("luminaire.yaw", "1.5707963267948966 rad");
    key(Key::enter);
    EXPECT_NEAR(lamp().yaw, 1.5707963267948966, 1e-12);
}

TEST_F(APanel, keeps_the_old_figure_when_the_typed_one_cannot_be_read) {
    show(with_panel_luminaire(scene));
    const Scene before = scene;
    EXPECT_EQ(type_into("luminaire.x", "2*") + key(Key::enter) + frames(2), 0);
    EXPECT_EQ(type_into("luminaire.x", "1 kg") + key(Key::enter) + frames(2), 0);
    EXPECT_EQ(scene, before);
}

TEST_F(APanel, shows_and_takes_lengths_in_the_preferred_unit) {
    show_units(LengthUnit::millimetre, IlluminanceUnit::lux);
    show(with_panel_luminaire(scene));
    type_into("luminaire.x", "1250");
    key(Key::enter);
    EXPECT_NEAR(lamp().position.x, 1.25, 1e-12);
    show_units(LengthUnit::feet_inches, IlluminanceUnit::lux);
    frames(2);
    type_into("luminaire.x", "5'-3 1/2\"");
    key(Key::enter);
    EXPECT_NEAR(lamp().position.x, 5 * 0.3048 + 3.5 * 0.0254, 1e-12);
    show_units(LengthUnit::metre, IlluminanceUnit::lux);
}

}  // namespace
}  // namespace hanei
