/// The effects plan at the desk: measured beside the frames, its bounds shown in the room.
#include "app/desktop.h"
#include "ui/window/driver.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

class Effects : public testing::Test {
protected:
    Driver::Setup setup() {
        Opened<ProjectContent> opened =
            project_door().open(std::filesystem::path(HANEI_SOURCE) / "assets/rooms/painted-room.hanei");
        EXPECT_TRUE(opened.content);
        opened.content->settings.max_patch = 1.0;
        return {*opened.content, "room.hanei", project_door()};
    }
    const EffectsPanel& panel() const { return driver_.workbench().readings().effects; }

    Driver driver_{setup()};
};

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

TEST_F(Effects, are_measured_and_their_bounds_shown_at_every_calculation_point) {
    ASSERT_TRUE(driver_.wait_settled());
    EXPECT_DONE(driver_.click("tab.Effects"));
    EXPECT_TRUE(panel().pointed().empty());
    EXPECT_DONE(driver_.click("effects.measure"));
    ASSERT_TRUE(driver_.wait_until([&] { return panel().trials().everything_ms > 0.0; }));
    EXPECT_FALSE(panel().busy());
    ASSERT_NE(panel().trials().of(Effect::three_bands), nullptr);
    EXPECT_EQ(panel().trials().places, 3U + 8U * 6U);

    EXPECT_DONE(driver_.point_at("effects.interreflection"));  // anywhere on the row will do
    driver_.frames(2);
    EXPECT_EQ(panel().pointed().size(), panel().trials().places);
    EXPECT_DONE(driver_.point_at("effects.measure"));
    driver_.frames(2);
    EXPECT_TRUE(panel().pointed().empty());
}

}  // namespace
}  // namespace hanei
