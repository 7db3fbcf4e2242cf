#include "computer_room.h"
#include "ui/panels/state_text.h"
#include "ui/view/standpoint.h"

#include <cmath>
#include <cstdlib>

namespace hanei {
namespace {

std::string state(const Driver& driver, const std::string& name) { return state_of(driver.workbench())[name]; }
const ViewState& view(const Driver& driver) { return driver.workbench().viewport().state; }
const ScreenRect* widget(const Driver& driver, const char* name) { return driver.workbench().widgets().find(name); }

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

TEST(ViewAids, a_click_on_an_axis_looks_along_it_and_another_one_from_the_opposite_side) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.click("axis.Z"));
    EXPECT_EQ(standpoint_of(view(driver).camera), Standpoint::plan);
    EXPECT_DONE(driver.click("axis.X"));
    EXPECT_EQ(standpoint_of(view(driver).camera), Standpoint::right);
    EXPECT_DONE(driver.click("axis.X"));
    EXPECT_EQ(standpoint_of(view(driver).camera), Standpoint::left);
    EXPECT_DONE(driver.click("axis.-Y"));
    EXPECT_EQ(standpoint_of(view(driver).camera), Standpoint::front);
    EXPECT_EQ(driver.workbench().chosen(), ObjectId{}) << "nothing behind the cross was meant";
}

TEST(ViewAids, the_cross_keeps_clear_of_the_scale_of_colours) {
    for (const PixelSize size : {PixelSize{1280, 800}, PixelSize{800, 600}}) {
        Driver::Setup setup = computer_room();
        setup.size = size;
        Driver driver(std::move(setup));
        const ScreenRect* const legend = widget(driver, "legend");
        const ScreenRect* const axis = widget(driver, "axis.X");
        if (legend == nullptr || axis == nullptr) continue;  // too small for one of them
        const bool apart = axis->right <= legend->left || axis->top >= legend->bottom;
        EXPECT_TRUE(apart) << size.width;
    }
}

TEST(ViewAids, drawings_have_a_scale_bar_and_perspective_has_none) {
    Driver driver(computer_room());
    EXPECT_EQ(widget(driver, "scale_bar"), nullptr);
    EXPECT_DONE(driver.press("P"));
    ASSERT_NE(widget(driver, "scale_bar"), nullptr);
    const float before = widget(driver, "scale_bar")->right - widget(driver, "scale_bar")->left;
    EXPECT_GT(before, 130.0F / 2.51F);
    driver.point_at(500.0F, 300.0F);
    driver.wheel(1.0F);
    const float closer = widget(driver, "scale_bar")->right - widget(driver, "scale_bar")->left;
    const double grown = static_cast<double>(closer / before);
    const auto is = [&](double factor) { return std::abs(grown - factor) < 0.01; };
    EXPECT_TRUE(is(1.15) || is(1.15 / 2.0) || is(1.15 / 2.5)) << grown;
    EXPECT_DONE(driver.click("menu.View"));
    EXPECT_DONE(driver.click("menu.View.Over the picture"));
    EXPECT_DONE(driver.click("view.scale_bar"));
    EXPECT_EQ(widget(driver, "scale_bar"), nullptr);
}

TEST(Measure, two_clicks_in_the_plan_say_how_far_the_places_are_apart) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.press("P"));
    EXPECT_DONE(driver.press("D"));
    const Room& room = *driver.workbench().document().shown()->room;
    const auto click_at = [&](const Vec2& place) {
        const auto at = driver.workbench().viewport().on_screen(Vec3(place, room.floor_height));
        ASSERT_TRUE(at);
        driver.point_at(at->x + 3.0F, at->y + 3.0F);  // beside it: it catches
        driver.button(0, true);
        driver.button(0, false);
    };
    click_at(room.plan[0]);
    driver.point_at(560.0F, 330.0F);
    EXPECT_NE(widget(driver, "measure.distance"), nullptr) << "it follows the pointer";
    click_at(room.plan[1]);
    EXPECT_NEAR(std::atof(state(driver, "measured").c_str()), glm::distance(room.plan[0], room.plan[1]), 1e-6);
    EXPECT_EQ(state(driver, "undo depth"), "0");
    EXPECT_EQ(state(driver, "selected"), "") << "clicks choose nothing meanwhile";
    click_at(room.plan[2]);
    driver.point_at(3.0F, 3.0F);
    EXPECT_EQ(state(driver, "measured"), "") << "a third click begins anew";
    EXPECT_DONE(driver.press("Esc"));
    EXPECT_FALSE(state_of(driver.workbench()).contains("measured"));
    EXPECT_DONE(driver.press("Ctrl+D"));  // not the same key
    EXPECT_FALSE(state_of(driver.workbench()).contains("measured"));
}

TEST(Measure, in_perspective_heights_count) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.click("bar.view.measure"));
    const Room& room = *driver.workbench().document().shown()->room;
    for (const double z : {0.0, room.height}) {
        // The far corner: in an overview its edge is seen.
        const Camera& camera = view(driver).camera;
        Vec2 far = room.plan[0];
        for (const Vec2& corner : room.plan)
            if (glm::distance(corner, Vec2(camera.eye)) > glm::distance(far, Vec2(camera.eye))) far = corner;
        const auto at = driver.workbench().viewport().on_screen(Vec3(far, room.floor_height + z));
        ASSERT_TRUE(at);
        driver.point_at(at->x, at->y);
        driver.button(0, true);
        driver.button(0, false);
    }
    EXPECT_NEAR(std::atof(state(driver, "measured").c_str()), room.height, 1e-6);
}

TEST(SavedViews, are_renamed_and_cut_in_their_menu_in_one_step_each) {
    Driver driver(computer_room());
    const auto views = [&] { return driver.workbench().document().shown()->views; };
    const std::string name = views().front().name;
    ASSERT_FALSE(name.empty());
    EXPECT_DONE(driver.click("view.views"));
    EXPECT_DONE(driver.click("views." + name + ".edit"));
    EXPECT_DONE(driver.click("views." + name + ".on"));
    EXPECT_TRUE(views().front().cut);
    EXPECT_EQ(state(driver, "undo depth"), "1");
    EXPECT_EQ(state(driver, "undo"), "Update view");
    EXPECT_DONE(driver.drag("views." + name + ".place", 30.0F, 0.0F));
    EXPECT_EQ(state(driver, "undo depth"), "2");
    EXPECT_DONE(driver.click("views." + name + ".name"));
    EXPECT_DONE(driver.press("Ctrl+A"));
    driver.type("Desk");
    EXPECT_DONE(driver.press("Enter"));
    EXPECT_EQ(views().front().name, "Desk");
    EXPECT_EQ(state(driver, "undo depth"), "3");
    EXPECT_EQ(state(driver, "undo"), "Rename view");
}

TEST(SavedViews, the_picture_follows_the_field_of_view_of_the_view_it_shows) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.press("Ctrl+K"));
    const std::string name = driver.workbench().document().shown()->views.back().name;
    EXPECT_DONE(driver.click("view.views"));
    EXPECT_DONE(driver.drag("section.field_of_view", 40.0F, 0.0F));
    const double wide = view(driver).camera.field_of_view;
    EXPECT_GT(wide, 0.6);
    EXPECT_EQ(state(driver, "undo depth"), "1") << "the present picture is no part of the project";
    EXPECT_DONE(driver.click("views." + name));
    EXPECT_LT(view(driver).camera.field_of_view, wide);
    EXPECT_DONE(driver.click("view.views"));
    EXPECT_DONE(driver.click("views." + name + ".edit"));
    EXPECT_DONE(driver.drag("views." + name + ".field_of_view", 50.0F, 0.0F));
    const double kept = driver.workbench().document().shown()->views.back().field_of_view;
    EXPECT_GT(kept, 0.6);
    EXPECT_EQ(view(driver).camera.field_of_view, kept);
}

}  // namespace
}  // namespace hanei
