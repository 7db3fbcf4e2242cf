#include "engine/scene/colour.h"
#include "room_by_hand.h"
#include "ui/view/band_light.h"
#include "ui/view/exact_picture.h"
#include "ui/view/frame.h"
#include "ui/view/offscreen.h"

#include <cmath>
#include <gtest/gtest.h>

namespace hanei {
namespace {

using Pixel = std::array<int, 3>;

/// Photos of one square from straight above, one context for all.
class APhoto : public testing::Test {
protected:
    static void SetUpTestSuite() { context_ = new OffscreenContext; }
    static void TearDownTestSuite() {
        delete context_;
        context_ = nullptr;
    }

    /// The square in this tint; light in bands where `bands` are given, one a corner.
    static std::shared_ptr<const Solution> square(const Vec3& tint, const std::vector<Vec3>& bands = {}) {
        auto solution = std::make_shared<Solution>(*test::single_cell({100.0F, 100.0F, 100.0F, 100.0F}));
        Scene scene = *solution->scene;
        for (Material& material : scene.materials) material.tint = tint;
        solution->scene = std::make_shared<const Scene>(scene);
        DisplayMesh display = *solution->display;
        for (const DisplayVertex& vertex : display.vertices) {
            if (bands.empty()) break;
            const Vec3& light = bands[vertex.position.x < 0.0 ? 0 : 1];
            display.tinted.push_back(
                {static_cast<float>(light.x), static_cast<float>(light.y), static_cast<float>(light.z)});
        }
        solution->display = std::make_shared<const DisplayMesh>(display);
        return solution;
    }

    static PictureRequest request(Scale scale = Scale::photo) {
        PictureRequest request;
        request.camera.eye = {0, 0, 10};
        request.camera.orthographic = true;
        request.camera.field_of_view = 2.0 * std::atan(0.1);  // 2 m high at 10 m
        request.options.scale = scale;
        request.options.isolux = false;
        request.options.luminaires = false;
        request.options.range = {10.0, 1000.0};
        request.size = {101, 101};
        request.annotated = false;
        return request;
    }

    static Pixel at(const Image& image, int x, int y) {
        const std::size_t place = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + x);
        return {image.rgba[place], image.rgba[place + 1], image.rgba[place + 2]};
    }

    static Image drawn(const std::shared_ptr<const Solution>& solution, Scale scale = Scale::photo) {
        return render_picture(solution, request(scale));
    }

    /// The same by rays, its direct light being 100 lx everywhere.
    static Image traced(const std::shared_ptr<const Solution>& solution) {
        const PictureRequest wished = request();
        ExactRequest exact;
        exact.camera = wished.camera;
        exact.options = wished.options;
        exact.size = wished.size;
        exact.samples = 1;
        const DirectLight even = [](std::span<const Receiver>, std::span<double> lux) {
            std::fill(lux.begin(), lux.end(), 100.0);
        };
        return exact_picture(*solution, even, exact, Work{})->room;
    }

    static void expect_near(const Pixel& found, const Pixel& expected, int tolerance) {
        for (std::size_t b = 0; b < 3; ++b) EXPECT_NEAR(found[b], expected[b], tolerance) << "primary " << b;
    }

    static OffscreenContext* context_;
    static constexpr Vec3 red{1.9, 0.78, 0.529};  // of luminance 1, to four digits
};
OffscreenContext* APhoto::context_ = nullptr;

TEST_F(APhoto, shows_a_surface_in_its_colour_and_false_colour_shows_the_lux) {
    const auto grey = square(Vec3(1.0)), painted = square(red);
    const Pixel plain = at(drawn(grey), 50, 50), shown = at(drawn(painted), 50, 50);
    EXPECT_GT(shown[0], plain[0] + 10);
    EXPECT_LT(shown[1], plain[1] - 5);
    EXPECT_LT(shown[2], plain[2] - 5);
    EXPECT_EQ(drawn(painted, Scale::false_colour).rgba, drawn(grey, Scale::false_colour).rgba);
}

TEST_F(APhoto, is_the_same_by_rays_but_for_the_grain) {
    for (const auto& solution : {square(Vec3(1.0)), square(red), square(red, {{150, 90, 52}, {60, 112, 99}})}) {
        const Image by_cells = drawn(solution), by_rays = traced(solution);
        for (const int x : {10, 50, 90}) expect_near(at(by_rays, x, 50), at(by_cells, x, 50), 2);  // grain: half a step
    }
}

TEST_F(APhoto, of_neutral_light_in_three_bands_is_that_of_one) {
    expect_near(at(drawn(square(red, {Vec3(100.0), Vec3(100.0)})), 50, 50), at(drawn(square(red)), 50, 50), 1);
}

TEST_F(APhoto, shows_white_paper_in_the_colour_of_the_light_from_side_to_side) {
    const Vec3 warm = 100.0 * light_of_temperature(2700.0), cold = 100.0 * light_of_temperature(10000.0);
    const Image image = drawn(square(Vec3(1.0), {warm, cold}));
    const Pixel left = at(image, 5, 50), middle = at(image, 50, 50), right = at(image, 95, 50);
    EXPECT_GT(left[0], left[2] + 40);
    EXPECT_GT(right[2], right[0] + 20);
    EXPECT_LT(middle[0], left[0]);
    EXPECT_GT(middle[0], right[0]);
}

TEST(BandLight, has_the_luminance_of_its_illuminance_everywhere_in_a_cell) {
    auto solution = *test::single_cell({10.0F, 20.0F, 40.0F, 30.0F});
    DisplayMesh display = *solution.display;
    EXPECT_EQ(bands_at(display, display.cells[0], {0.3, 0.6}, 17.0), Vec3(17.0)) << "one band stands for three";
    display.tinted = {{5, 11, 15}, {30, 17, 20}, {40, 41, 30}, {0, 0, 0}};
    for (double u = 0.0; u <= 1.0; u += 0.25) {
        for (double v = 0.0; v <= 1.0; v += 0.25)
            EXPECT_NEAR(luminance(bands_at(display, display.cells[0], {u, v}, 17.0)), 17.0, 1e-12);
    }
    const std::array<double, 4> lux{10.0, 20.0, 40.0, 30.0};
    const auto [of_red, of_green, of_blue] = bands_at_corners(display, display.cells[0], lux);
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3 bands{of_red[k], of_green[k], of_blue[k]};
        EXPECT_NEAR(luminance(bands), lux[k], 1e-12);
    }
}

TEST(BandLight, is_neutral_where_no_light_arrives) {
    auto solution = *test::single_cell({0, 0, 0, 0});
    DisplayMesh display = *solution.display;
    display.tinted.assign(display.vertices.size(), {0.0F, 0.0F, 0.0F});
    EXPECT_EQ(bands_at(display, display.cells[0], {0.5, 0.5}, 3.0), Vec3(3.0));
}

}  // namespace
}  // namespace hanei
