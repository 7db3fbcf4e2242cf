#include "ui/view/exact_picture.h"

#include "room_by_hand.h"
#include "ui/view/sight.h"
#include "ui/view/tone.h"

#include <atomic>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace hanei {
namespace {

/// Direct light as a function of the place.
DirectLight light_field(std::function<double(const Vec3&)> lux_at) {
    return [lux_at = std::move(lux_at)](std::span<const Receiver> receivers, std::span<double> lux) {
        for (std::size_t k = 0; k < lux.size(); ++k) lux[k] = lux_at(receivers[k].position);
    };
}

/// The square of 2 m at z = 0 from straight above, filling the picture; greys of a linear scale.
ExactRequest square_request(int pixels = 200) {
    ExactRequest request;
    request.camera.eye = {0, 0, 10};
    request.camera.orthographic = true;
    request.camera.field_of_view = 2.0 * std::atan(0.1);
    request.options.isolux = false;
    request.options.part = LightPart::direct;
    request.options.steps = ColourSteps::linear;
    request.options.range = {0.0, 100.0};
    request.size = {pixels, pixels};
    return request;
}

ExactRequest room_request(const Solution& solution) {
    ExactRequest request;
    request.size = {320, 200};
    request.options.range = suggested_range(solution);
    request.camera = overview(bounds_of(*solution.scene), request.size.aspect());
    return request;
}

int red(const ExactPicture& picture, int x, int y) { return picture.room.rgba[4 * picture.values.at(x, y)]; }

TEST(AnExactPicture, shows_at_every_pixel_the_light_of_the_place_its_centre_meets) {
    const auto solution = test::single_cell({10.0F, 20.0F, 40.0F, 30.0F});
    const auto ripples = [](const Vec3& place) { return 50.0 + 30.0 * std::sin(40.0 * place.x) * place.y; };
    const auto picture = exact_picture(*solution, light_field(ripples), square_request(), Work{});
    ASSERT_TRUE(picture);
    for (int y = 0; y < 200; ++y) {
        for (int x = 0; x < 200; ++x) {
            const Vec3 place((x + 0.5) / 100.0 - 1.0, 1.0 - (y + 0.5) / 100.0, 0.0);
            ASSERT_NEAR(picture->values.lux[picture->values.at(x, y)], ripples(place), 1e-4)  // stored as float
                << x << " " << y;
        }
    }
}

TEST(AnExactPicture, lays_interpolated_interreflected_light_over_direct_light) {
    auto solution = std::make_shared<Solution>(*test::single_cell({0, 0, 0, 0}));
    DisplayMesh display = *solution->display;
    for (DisplayVertex& vertex : display.vertices)
        vertex.interreflected = static_cast<float>(50.0 + 20.0 * vertex.position.x + 5.0 * vertex.position.y);
    solution->display = std::make_shared<const DisplayMesh>(display);
    const DirectLight direct = light_field([](const Vec3& place) { return 7.0 + place.x * place.x; });
    ExactRequest request = square_request(50);
    for (const LightPart part : {LightPart::total, LightPart::interreflected, LightPart::direct}) {
        request.options.part = part;
        const auto picture = exact_picture(*solution, direct, request, Work{});
        ASSERT_TRUE(picture);
        const double x = -1.0 + 12.5 * 0.04, y = 1.0 - 12.5 * 0.04;  // the centre of pixel 12, 12 of 50 in 2 m
        const double straight = part == LightPart::interreflected ? 0.0 : 7.0 + x * x;
        const double by_way = part == LightPart::direct ? 0.0 : 50.0 + 20.0 * x + 5.0 * y;
        EXPECT_NEAR(picture->values.lux[picture->values.at(12, 12)], straight + by_way, 1e-4);
    }
}

TEST(AnExactPicture, has_the_same_bits_on_any_number_of_threads) {
    const auto solution = test::solution_by_hand(test::furnished_room(), test::pleasant_light);
    const DirectLight stripes =
        light_field([](const Vec3& place) { return 100.0 + 90.0 * std::sin(9.0 * (place.x + place.y + place.z)); });
    const ExactRequest request = room_request(*solution);
    const auto one = exact_picture(*solution, stripes, request, Work{1});
    for (const int threads : {2, 7}) {
        const auto more = exact_picture(*solution, stripes, request, Work{threads});
        ASSERT_TRUE(one && more);
        EXPECT_EQ(one->room.rgba, more->room.rgba);
        EXPECT_EQ(one->values.lux, more->values.lux);
        EXPECT_EQ(one->refined, more->refined);
    }
}

TEST(AnExactPicture, is_empty_when_stopped_and_asks_for_little_more_light) {
    const auto solution = test::solution_by_hand(test::furnished_room(), test::pleasant_light);
    std::stop_source wish;
    std::atomic<std::size_t> asked = 0, asked_before = 0;
    const DirectLight stops = [&](std::span<const Receiver> receivers, std::span<double> lux) {
        std::fill(lux.begin(), lux.end(), 1.0);
        asked += receivers.size();
        if (asked < 20'000 || wish.stop_requested()) return;
        asked_before = asked.load();
        wish.request_stop();
    };
    EXPECT_FALSE(exact_picture(*solution, stops, room_request(*solution), Work{2, wish.get_token()}));
    EXPECT_GE(asked_before, 20'000u);
    EXPECT_LE(asked - asked_before, 2u * 64u * 16u);  // what two threads had begun: 64 pixels of 16 rays
}

TEST(AnExactPicture, draws_the_border_of_a_slanted_shadow_in_as_many_tones_as_it_has_rays) {
    const auto solution = test::single_cell({0, 0, 0, 0});
    const DirectLight half_plane =
        light_field([](const Vec3& place) { return place.x + 0.037 * place.y > 0.003 ? 90.0 : 10.0; });
    ExactRequest request = square_request();
    request.samples = 1;
    const auto hard = exact_picture(*solution, half_plane, request, Work{});
    request.samples = 16;
    const auto smooth = exact_picture(*solution, half_plane, request, Work{});
    ASSERT_TRUE(hard && smooth);
    EXPECT_EQ(hard->refined, 0u);
    EXPECT_GT(smooth->refined, 200u);
    EXPECT_LT(smooth->refined, 200u * 6u);  // two or three pixels a row beside the border
    std::set<int> tones_hard, tones_smooth;
    for (int y = 0; y < 200; ++y) {
        for (int x = 0; x < 200; ++x) {
            tones_hard.insert(red(*hard, x, y));
            tones_smooth.insert(red(*smooth, x, y));
        }
        for (int x = 1; x < 200; ++x) EXPECT_GE(red(*smooth, x, y), red(*smooth, x - 1, y));
    }
    EXPECT_EQ(tones_hard.size(), 2u);
    EXPECT_GE(tones_smooth.size(), 10u);
}

TEST(AnExactPicture, covers_the_pixels_on_an_objects_outline_in_part) {
    const auto solution = test::single_cell({50, 50, 50, 50});
    ExactRequest request = square_request();
    request.camera.field_of_view = 2.0 * std::atan(0.15);  // the square and 0.5 m around it
    request.camera.target = {0.001, 0.002, 0.0};           // its sides fall between pixels
    request.camera.eye = {0.001, 0.002, 10.0};
    const auto picture = exact_picture(*solution, light_field([](const Vec3&) { return 50.0; }), request, Work{});
    ASSERT_TRUE(picture);
    double covered = 0.0;
    int in_part = 0;
    for (std::size_t pixel = 0; pixel < 200u * 200u; ++pixel) {
        const int opacity = picture->room.rgba[4 * pixel + 3];
        covered += opacity / 255.0;
        in_part += opacity > 0 && opacity < 255 ? 1 : 0;
    }
    EXPECT_GT(in_part, 300);
    const double side = 2.0 / 3.0 * 200.0;                       // pixels
    EXPECT_NEAR(covered, side * side, 0.5 / 16.0 * 4.0 * side);  // half a ray of 16 along four sides
}

TEST(AnExactPicture, gives_no_extra_rays_to_a_gentle_slope) {
    const auto solution = test::single_cell({0, 0, 0, 0});
    const DirectLight slope = light_field([](const Vec3& place) { return 50.0 + 40.0 * place.x; });
    ExactRequest request = square_request();
    request.camera.field_of_view = 2.0 * std::atan(0.05);  // inside the square
    const auto picture = exact_picture(*solution, slope, request, Work{});
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->refined, 0u);
}

TEST(AnExactPicture, tells_how_far_it_is_and_never_less) {
    const auto solution = test::solution_by_hand(test::furnished_room(), test::pleasant_light);
    Progress progress;
    float last = 0.0F;
    bool falls = false;
    const DirectLight watching = [&](std::span<const Receiver>, std::span<double> lux) {
        std::fill(lux.begin(), lux.end(), 1.0);
        falls = falls || progress.fraction() < last;
        last = progress.fraction();
    };
    ASSERT_TRUE(exact_picture(*solution, watching, room_request(*solution), Work{1, {}, &progress}));
    EXPECT_FALSE(falls);
    EXPECT_GT(last, 0.5F);
    EXPECT_FLOAT_EQ(progress.fraction(), 1.0F);
}

TEST(Sight, meets_no_gap_where_corners_of_cells_lie_on_edges_of_others) {
    const auto solution = test::square_with_hanging_corners(50.0F);
    Camera camera;
    camera.eye = {0.3, -0.2, 1.5};
    camera.target = {0.0, 0.0, 0.0};
    camera.field_of_view = 0.9;
    const Sight sight(*solution, camera, 1.0);
    for (int column = 0; column < 7; ++column) {  // straight at the cells' common borders
        for (int k = 0; k < 4000; ++k) {
            const Vec3 place(-1.0 + 2.0 * column / 7.0 + 1e-16 * k, -0.999 + 1.998 * k / 4000.0, 0.0);
            if (column == 0) continue;
            const auto at = projected(camera, place, 1.0);
            ASSERT_TRUE(at);
            const auto seen = sight.through(*at);
            ASSERT_TRUE(seen) << column << " " << k;
            EXPECT_LT(glm::length(seen->place - place), 1e-9);
        }
    }
}

TEST(Sight, looks_through_the_backs_of_faces) {
    const auto solution = test::single_cell({50, 50, 50, 50});
    Camera camera;
    camera.eye = {0.0, 0.1, -3.0};
    EXPECT_FALSE(Sight(*solution, camera, 1.0).through({0.5, 0.5}));
    camera.eye.z = 3.0;
    const auto seen = Sight(*solution, camera, 1.0).through({0.5, 0.5});
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->depth, std::hypot(3.0, 0.1), 1e-12);
}

TEST(ATone, goes_to_the_screen_and_back) {
    for (int k = 0; k <= 255; ++k) {
        const glm::vec3 shown(static_cast<float>(k) / 255.0F);
        EXPECT_NEAR(encoded_srgb(linear_srgb(shown)).x, shown.x, 1e-5F);
    }
    double before = -1.0;
    for (double shown = 0.0; shown < 20.0; shown += 0.01) {
        const double grey = static_cast<double>(photographed(Vec3(shown)).y);
        EXPECT_GE(grey, before);
        EXPECT_LE(grey, 1.0);
        before = grey;
    }
}

}  // namespace
}  // namespace hanei
