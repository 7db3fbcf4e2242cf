#include "ui/panels/section.h"

#include "ui/panels/saved_views.h"
#include "ui/view/standpoint.h"

#include <cmath>
#include <gtest/gtest.h>

namespace hanei {
namespace {

const Bounds office{{0, 0, 0}, {6, 4, 2.8}};

TEST(Section, opens_the_room_towards_the_eye) {
    for (const Standpoint standpoint : standpoints) {
        const Camera camera = camera_at(standpoint, office, 1.5);
        for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
            const Cut cut = section_across(axis, camera, office);
            EXPECT_GE(glm::dot(cut.normal, camera.eye - camera.target), -1e-6) << name_of(standpoint);
            const Vec3 handle = handle_of(cut, office);
            EXPECT_NEAR(glm::dot(handle, cut.normal), cut.offset, 1e-12);
        }
    }
    EXPECT_NEAR(section_across(Axis::z, camera_at(Standpoint::plan, office, 1.5), office).offset, 1.2, 1e-12);
}

TEST(Section, turned_over_twice_is_itself_and_keeps_its_place) {
    const Cut cut{{0, 1, 0}, 1.5};
    EXPECT_TRUE(flipped(flipped(cut)) == cut);
    EXPECT_LT(glm::distance(handle_of(flipped(cut), office), handle_of(cut, office)), 1e-12);
}

TEST(Section, follows_the_pointer_along_its_normal_on_the_raster_and_within_the_room) {
    const Cut cut{{0, 1, 0}, 1.5};
    const Vec3 handle = handle_of(cut, office);
    const auto pointed = [&](double y) { return Ray{{handle.x, y, 9.0}, {0, 0, -1}}; };
    EXPECT_NEAR(moved_to(cut, pointed(2.33), office, 0.0).offset, 2.33, 1e-12);
    EXPECT_NEAR(moved_to(cut, pointed(2.33), office, 0.1).offset, 2.3, 1e-12);
    EXPECT_NEAR(moved_to(cut, pointed(-7.0), office, 0.1).offset, 0.0, 1e-12);
    EXPECT_NEAR(moved_to(cut, pointed(70.0), office, 0.1).offset, 4.0, 1e-12);
    EXPECT_TRUE(moved_to(cut, Ray{{3, 9, 1.4}, {0, -1, 0}}, office, 0.1) == cut) << "looked at along its normal";
}

TEST(SavedViews, are_kept_updated_put_in_order_and_thrown_away) {
    Scene scene;
    Camera camera = camera_at(Standpoint::front, office, 1.5);
    for (int k = 0; k < 3; ++k) scene = with_kept_view(std::move(scene), camera).scene;
    ASSERT_EQ(scene.views.size(), 3U);
    EXPECT_NE(scene.views[0].name, scene.views[1].name);
    const ObjectId last = scene.views[2].id;
    const std::string name = scene.views[2].name;
    camera.left_out.ceiling = true;
    scene = with_updated_view(std::move(scene), last, camera).scene;
    EXPECT_TRUE(camera_of(scene.views[2]) == camera);
    EXPECT_EQ(scene.views[2].name, name);
    scene = with_view_moved_up(std::move(scene), last).scene;
    EXPECT_EQ(scene.views[1].id, last);
    scene = with_view_moved_up(with_view_moved_up(std::move(scene), last).scene, last).scene;
    EXPECT_EQ(scene.views[0].id, last) << "the first stays the first";
    scene = without_view(std::move(scene), last).scene;
    EXPECT_EQ(scene.views.size(), 2U);
}

}  // namespace
}  // namespace hanei
