#include "ui/panels/exact_room.h"

#include "engine/study/pixel_light.h"
#include "engine/study/study.h"
#include "tests/box_room.h"
#include "ui/panels/time_left.h"
#include "ui/view/sight.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

/// A table, one board 2 cm thick, under a panel.
Scene table_under_panel() {
    Scene scene = test::box_room({4.0, 3.0, 2.8}, 0.5);
    scene.furniture.push_back(test::box(scene, {2.0, 1.5, 0.0}, {1.2, 0.6, 0.02}));
    scene.furniture.back().position.z = 0.7;
    scene.luminaires.push_back(test::panel(scene, {2.0, 1.5, 2.79}, {0.6, 0.6}, 3000.0));
    return scene;
}

class ExactRoom : public testing::Test {
protected:
    static void SetUpTestSuite() {
        Settings settings;
        settings.max_patch = 0.6;
        settings.threads = 1;
        solution_ = Study().run(std::make_shared<const Scene>(table_under_panel()), settings,
                                {.display = true, .unshadowed = true}, Work{});
    }
    static void TearDownTestSuite() { solution_.reset(); }

    /// The floor beside and under the table, seen from the corner.
    static ExactRequest request(LightPart part) {
        ExactRequest request;
        request.camera.eye = {0.2, 0.2, 0.9};
        request.camera.target = {2.0, 1.5, 0.2};
        request.options.part = part;
        request.options.range = suggested_range(*solution_);
        request.size = {160, 100};
        return request;
    }

    static SolutionSnapshot solution_;
};
SolutionSnapshot ExactRoom::solution_;

TEST_F(ExactRoom, has_at_its_pixels_the_direct_light_that_is_reported_there) {
    const ExactRequest asked = request(LightPart::direct);
    const auto room = exact_room(solution_, asked, Work{});
    ASSERT_TRUE(room);
    const Sight sight(*solution_, asked.camera, asked.size.aspect());
    int dark = 0, lit = 0;
    for (int y = 3; y < asked.size.height; y += 7) {
        for (int x = 2; x < asked.size.width; x += 7) {
            const auto seen = sight.through({(x + 0.5) / asked.size.width, (y + 0.5) / asked.size.height});
            ASSERT_TRUE(seen);
            const Vec3& normal = solution_->mesh->faces[solution_->display->cells[seen->cell].face].face.normal;
            const double reported = value_at(*solution_, seen->place, normal).direct.value;
            EXPECT_NEAR(room->values.lux[room->values.at(x, y)], reported, 1e-6 * reported);  // stored as float
            (reported > 0.0 ? lit : dark) += 1;
        }
    }
    EXPECT_GT(dark, 10);
    EXPECT_GT(lit, 50);
}

TEST_F(ExactRoom, has_a_penumbra_that_only_rises) {
    ExactRequest asked = request(LightPart::direct);
    asked.camera.orthographic = true;
    asked.camera.eye = {2.0, 1.5, 0.5};  // below the board, down to the floor
    asked.camera.target = {2.0, 1.5, 0.0};
    asked.camera.field_of_view = 2.0 * std::atan(1.4 / 0.5);  // 2.8 m of the floor's 3
    asked.size = {140, 280};
    const auto room = exact_room(solution_, asked, Work{});
    ASSERT_TRUE(room);
    int between = 0;
    for (int x : {10, 70, 130}) {
        for (int y = 141; y < 190; ++y) {  // from the middle to 0.5 m beside it: the penumbra ends at 0.51 m
            const float nearer = room->values.lux[room->values.at(x, y - 1)];
            const float farther = room->values.lux[room->values.at(x, y)];
            EXPECT_GE(farther, nearer) << x << " " << y;
            between += farther > nearer ? 1 : 0;
        }
    }
    EXPECT_GT(between, 30);
}

TEST_F(ExactRoom, shows_each_part_and_their_sum) {
    const auto total = exact_room(solution_, request(LightPart::total), Work{});
    const auto direct = exact_room(solution_, request(LightPart::direct), Work{});
    const auto interreflected = exact_room(solution_, request(LightPart::interreflected), Work{});
    ASSERT_TRUE(total && direct && interreflected);
    for (std::size_t pixel = 0; pixel < total->values.lux.size(); ++pixel)
        ASSERT_NEAR(total->values.lux[pixel], direct->values.lux[pixel] + interreflected->values.lux[pixel], 1e-3);
}

TEST_F(ExactRoom, has_no_shadow_in_the_part_without_shadows) {
    const ExactRequest asked = request(LightPart::unshadowed);
    const auto open = exact_room(solution_, asked, Work{});
    const auto total = exact_room(solution_, request(LightPart::total), Work{});
    ASSERT_TRUE(open && total);
    const PixelLight without(solution_, false);
    const Sight sight(*solution_, asked.camera, asked.size.aspect());
    int brighter = 0;
    for (std::size_t pixel = 0; pixel < open->values.lux.size(); ++pixel) {
        const std::size_t x = pixel % 160, y = pixel / 160;
        const auto seen =
            sight.through({(static_cast<double>(x) + 0.5) / 160.0, (static_cast<double>(y) + 0.5) / 100.0});
        const Receiver receiver{seen->place, sight.frame(seen->cell).normal, Vec3(0.0)};
        double lux = 0.0;
        without.direct({&receiver, 1}, {&lux, 1});
        ASSERT_GE(open->values.lux[pixel], lux * (1.0 - 1e-6));
        brighter += open->values.lux[pixel] > 2.0F * total->values.lux[pixel] ? 1 : 0;
    }
    EXPECT_GT(brighter, 500);  // under the table
}

TEST_F(ExactRoom, has_the_same_bits_on_one_two_and_seven_threads) {
    const auto one = exact_room(solution_, request(LightPart::total), Work{1});
    for (const int threads : {2, 7}) {
        const auto more = exact_room(solution_, request(LightPart::total), Work{threads});
        ASSERT_TRUE(one && more);
        EXPECT_EQ(one->room.rgba, more->room.rgba);
    }
}

TEST_F(ExactRoom, is_null_when_stopped) {
    std::stop_source wish;
    wish.request_stop();
    EXPECT_FALSE(exact_room(solution_, request(LightPart::total), Work{2, wish.get_token()}));
}

TEST(TimeLeft, is_told_once_enough_is_done_to_tell) {
    TimeLeft left;
    const auto start = TimeLeft::Clock::now();
    EXPECT_FALSE(left.seconds(Stage::refining, 0.0F, start));
    EXPECT_FALSE(left.seconds(Stage::refining, 0.01F, start + std::chrono::seconds(1)));
    const auto rest = left.seconds(Stage::refining, 0.25F, start + std::chrono::seconds(2));
    ASSERT_TRUE(rest);
    EXPECT_NEAR(*rest, 6.0, 1e-9);
    EXPECT_FALSE(left.seconds(Stage::done, 0.25F, start + std::chrono::seconds(3)));
    EXPECT_EQ(time_left_text(6.0), "6 s left");
    EXPECT_EQ(time_left_text(125.0), "3 min left");
    EXPECT_EQ(time_left_text(std::nullopt), "");
}

}  // namespace
}  // namespace hanei
