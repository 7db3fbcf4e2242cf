#include "room_by_hand.h"
#include "ui/view/colour_scale.h"
#include "ui/view/drawn_about.h"
#include "ui/view/frame.h"
#include "ui/view/offscreen.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

namespace hanei {
namespace {

using test::furnished_room;
using test::pleasant_light;
using test::solution_by_hand;

/// One context for all pictures of this program, as `render` has.
class Picture : public testing::Test {
protected:
    static void SetUpTestSuite() { context_ = new OffscreenContext; }
    static void TearDownTestSuite() {
        delete context_;
        context_ = nullptr;
    }
    static OffscreenContext* context_;

    /// Kept for the eye when HANEI_PICTURES names a folder.
    static void keep(const Image& image, const std::string& name) {
        if (const char* folder = std::getenv("HANEI_PICTURES")) write_png(image, std::filesystem::path(folder) / name);
    }

    static std::array<int, 3> pixel(const Image& image, int x, int y) {
        const std::size_t at =
            4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
        return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]};
    }
    static int difference(const std::array<int, 3>& a, const std::array<int, 3>& b) {
        return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
    }

    static PictureRequest request_for(const Solution& solution) {
        PictureRequest request;
        request.options.range = suggested_range(solution);
        request.camera = overview(bounds_of(*solution.scene), view_size(request).aspect());
        return request;
    }

    /// The single cell from straight above, filling the picture, colours only.
    static PictureRequest cell_request() {
        PictureRequest request;
        request.camera.eye = {0, 0, 10};
        request.camera.target = {0, 0, 0};
        request.camera.orthographic = true;
        request.camera.field_of_view = 2.0 * std::atan(0.1);  // 2 m high at 10 m
        request.options.isolux = false;
        request.options.steps = ColourSteps::linear;
        request.options.range = {0.0, 100.0};
        request.options.luminaires = false;
        request.size = {201, 201};
        request.annotated = false;
        return request;
    }
};
OffscreenContext* Picture::context_ = nullptr;

TEST_F(Picture, has_the_same_bytes_when_drawn_twice) {
    const auto solution = solution_by_hand(furnished_room(), pleasant_light);
    const PictureRequest request = request_for(*solution);
    const Image first = render_picture(solution, request);
    const Image second = render_picture(solution, request);
    EXPECT_EQ(first.width, 1280);
    EXPECT_EQ(first.height, 800);
    EXPECT_TRUE(first.rgba == second.rgba);
    keep(first, "overview.png");
}

TEST_F(Picture, of_a_photo_and_of_every_part_differ) {
    const auto solution = solution_by_hand(furnished_room(), pleasant_light, 0.1);
    PictureRequest request = request_for(*solution);
    const Image total = render_picture(solution, request);
    keep(total, "fine.png");
    request.options.part = LightPart::direct;
    const Image direct = render_picture(solution, request);
    request.options.scale = Scale::photo;
    const Image photo = render_picture(solution, request);
    keep(photo, "photo_direct.png");
    request.options.part = LightPart::total;
    keep(render_picture(solution, request), "photo.png");
    EXPECT_FALSE(total.rgba == direct.rgba);
    EXPECT_FALSE(direct.rgba == photo.rgba);
}

TEST_F(Picture, four_up_names_what_was_not_computed_instead_of_drawing_zeros) {
    const auto whole = solution_by_hand(furnished_room(), pleasant_light);
    auto without = std::make_shared<Solution>(*whole);
    auto display = std::make_shared<DisplayMesh>(*whole->display);
    display->has_unshadowed = false;
    for (DisplayVertex& vertex : display->vertices) vertex.unshadowed = 0.0F;
    without->display = display;
    const PictureRequest request = request_for(*whole);
    const Image four = render_four_up(whole, request);
    const Image missing = render_four_up(without, request);
    keep(four, "four_up.png");
    keep(missing, "four_up_missing.png");
    EXPECT_EQ(four.width, request.size.width);
    EXPECT_EQ(four.height, request.size.height);
    EXPECT_FALSE(four.rgba == missing.rgba);
}

TEST_F(Picture, of_a_saddle_shows_no_diagonal) {
    // 0 100 / 100 0: bilinear is the same along both diagonals, two triangles are not.
    const auto solution = test::single_cell({0.0F, 100.0F, 0.0F, 100.0F});
    const Image image = render_picture(solution, cell_request());
    keep(image, "saddle.png");
    for (int k = 5; k < 196; ++k) {
        // The field is symmetric under a mirror that takes corner values 0 to 0: both diagonals of
        // mirrored places agree up to the rounding of one step of colour.
        EXPECT_LE(difference(pixel(image, k, 100), pixel(image, 100, k)), 2) << k;
        EXPECT_LE(difference(pixel(image, k, k), pixel(image, 200 - k, 200 - k)), 2) << k;
    }
    // On the cell's middle lines the value is 50 everywhere; triangles would give 0 to 100 there.
    ViewOptions options = cell_request().options;
    const glm::vec3 middle = 255.0F * colour_of(50.0, options);
    for (int k = 5; k < 196; ++k) {
        EXPECT_LE(difference(pixel(image, k, 100), {int(middle.x + 0.5F), int(middle.y + 0.5F), int(middle.z + 0.5F)}),
                  3)
            << k;
    }
}

TEST_F(Picture, colours_are_those_of_the_scale) {
    for (const float lux : {5.0F, 50.0F, 95.0F, 150.0F}) {
        const auto solution = test::single_cell({lux, lux, lux, lux});
        const Image image = render_picture(solution, cell_request());
        const glm::vec3 expected = 255.0F * colour_of(static_cast<double>(lux), cell_request().options);
        // One step of 8 bit colour each for the table's and the framebuffer's rounding.
        EXPECT_LE(difference(pixel(image, 100, 100),
                             {int(expected.x + 0.5F), int(expected.y + 0.5F), int(expected.z + 0.5F)}),
                  2)
            << lux;
    }
}

TEST_F(Picture, shows_no_background_between_cells_whose_corners_do_not_meet) {
    const auto solution = test::square_with_hanging_corners(50.0F);
    PictureRequest request = cell_request();
    request.size = {700, 700};
    request.camera.orthographic = false;
    request.camera.field_of_view = 0.7;
    const glm::vec3 expected = 255.0F * colour_of(50.0, request.options);
    const std::array<int, 3> even{int(expected.x + 0.5F), int(expected.y + 0.5F), int(expected.z + 0.5F)};
    for (int k = 0; k < 8; ++k) {  // oblique views, each with other roundings
        request.camera.eye = {0.7 * std::sin(1.1 * k), 0.7 * std::cos(1.7 * k), 1.1 + 0.05 * k};
        const Image image = render_picture(solution, request);
        for (int y = 200; y < 500; ++y) {
            for (int x = 200; x < 500; ++x)
                ASSERT_LE(difference(pixel(image, x, y), even), 2) << k << ' ' << x << ' ' << y;
        }
    }
}

TEST_F(Picture, of_a_plateau_on_a_step_is_not_covered_by_a_line) {
    const auto solution = test::single_cell({50.0F, 50.0F, 50.0F, 50.0F});
    PictureRequest request = cell_request();
    const Image plain = render_picture(solution, request);
    request.options.isolux = true;
    const Image lined = render_picture(solution, request);
    EXPECT_TRUE(pixel(plain, 100, 100) == pixel(lined, 100, 100));
}

TEST_F(Picture, line_of_equal_illuminance_runs_where_the_light_has_its_value) {
    // 0 at the left edge, 100 at the right: 50 lx in the middle column.
    const auto solution = test::single_cell({0.0F, 100.0F, 100.0F, 0.0F});
    PictureRequest request = cell_request();
    const Image plain = render_picture(solution, request);
    request.options.isolux = true;
    const Image lined = render_picture(solution, request);
    EXPECT_GT(difference(pixel(plain, 100, 60), pixel(lined, 100, 60)), 30);
    EXPECT_EQ(difference(pixel(plain, 90, 60), pixel(lined, 90, 60)), 0);
    EXPECT_EQ(difference(pixel(plain, 110, 60), pixel(lined, 110, 60)), 0);
}

TEST_F(Picture, before_any_solution_shows_the_room_in_greys) {
    const Scene scene = furnished_room();
    auto solution = std::make_shared<Solution>();
    solution->scene = std::make_shared<const Scene>(scene);
    PictureRequest request;
    request.annotated = false;
    request.camera = overview(bounds_of(scene), request.size.aspect());
    const Image image = render_picture(solution, request);
    keep(image, "plain.png");
    const auto middle = pixel(image, 640, 420);
    EXPECT_LT(difference({middle[0], middle[0], middle[0]}, middle), 16);
}

TEST_F(Picture, plan_view_shows_floor_and_furniture) {
    const auto solution = solution_by_hand(furnished_room(), pleasant_light, 0.1);
    PictureRequest request = request_for(*solution);
    request.camera = plan_view(bounds_of(*solution->scene), view_size(request).aspect());
    request.options.mesh_lines = true;
    request.options.steps = ColourSteps::standard_steps;
    const Image image = render_picture(solution, request);
    keep(image, "plan.png");
    const auto corner = pixel(image, 4, 4), centre = pixel(image, 560, 300);
    EXPECT_GT(difference(corner, centre), 40);
}

TEST_F(Picture, highlights_change_only_the_neighbourhood_of_what_they_outline) {
    const Scene scene = furnished_room();
    Renderer renderer;
    renderer.set_scene(std::make_shared<const Scene>(scene));
    const PixelSize size{800, 500};
    const Camera camera = overview(bounds_of(scene), size.aspect());
    const auto draw = [&](const Highlights& highlights) {
        Frame frame(size);
        renderer.draw(camera, ViewOptions{}, highlights, size);
        return frame.read();
    };
    Highlights highlights;
    const Image plain = draw(highlights);
    highlights.selected = {scene.furniture.front().id};
    highlights.hovered = scene.luminaires[1].id;
    highlights.lines = {{{0, 0, 0}, {1, 0, 0}, {1, 0, 0, 1}}};
    const Image outlined = draw(highlights);
    keep(outlined, "highlights.png");
    int changed = 0;
    for (std::size_t k = 0; k < plain.rgba.size(); k += 4) changed += plain.rgba[k] != outlined.rgba[k] ? 1 : 0;
    EXPECT_GT(changed, 500);
    EXPECT_LT(changed, size.width * size.height / 10);
}

/// Single precision steps by 64 mm there.
TEST_F(Picture, of_a_room_a_thousand_kilometres_away_is_that_of_the_room_nearby) {
    const Vec3 away{1048576.0, -524288.0, 0.0};
    const PixelSize size{640, 400};
    const auto draw = [&](const Scene& scene) {
        Renderer renderer;
        renderer.set_scene(std::make_shared<const Scene>(scene));
        Frame frame(size);
        renderer.draw(overview(bounds_of(scene), size.aspect()), ViewOptions{}, {}, size);
        return frame.read();
    };
    Scene scene = furnished_room();
    scene.grids.clear();
    scene.points.clear();
    const Image nearby = draw(scene);
    for (Vec2& corner : scene.room->plan) corner += Vec2(away);
    for (Furniture& furniture : scene.furniture) furniture.position += away;
    for (Luminaire& luminaire : scene.luminaires) luminaire.position += away;
    for (FreeSurface& surface : scene.surfaces)
        for (Vec3& corner : surface.region.outline) corner += away;
    const Image far = draw(scene);
    keep(far, "far.png");
    int changed = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) changed += difference(pixel(nearby, x, y), pixel(far, x, y)) > 24 ? 1 : 0;
    EXPECT_LT(changed, size.width * size.height / 500) << "pixels at rounded edges may differ";
}

TEST(DrawingOrigin, is_the_scenes_own_while_that_is_near_and_stays_while_the_scene_is_edited) {
    EXPECT_EQ(drawing_origin({{-3.0, 2.0, 0.0}, {9.0, 7.0, 3.0}}), Vec3(0.0));
    EXPECT_EQ(drawing_origin({{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}), Vec3(0.0));
    const Bounds far{{1e5, -1e5, 0.0}, {1e5 + 4.0, -1e5 + 3.0, 2.6}};
    const Vec3 origin = drawing_origin(far);
    EXPECT_LT(glm::distance(origin, far.low), 512.0);
    EXPECT_EQ(drawing_origin({far.low + Vec3(0.3), far.high + Vec3(0.3)}), origin);
}

}  // namespace
}  // namespace hanei
