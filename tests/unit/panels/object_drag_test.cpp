#include "ui/panels/object_drag.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace hanei {
namespace {

Ray ray(Vec3 origin, Vec3 towards) { return {origin, glm::normalize(towards - origin)}; }

constexpr double exact = 1e-9;  // rounding of a ray 8 m long, divided by a sine of 0.4
const Vec3 eye{0.0, -5.0, 6.0};

/// A lamp of an empty room at (3, 2, 2.3), dragged without catching at anything but what a test sets.
struct Dragging {
    Added lamp = with_point_luminaire(empty_room());
    SceneSnapshot scene = std::make_shared<const Scene>(lamp.scene);
    Vec3 start = *place_of(*scene, lamp.object);
    SnapSettings snap{false, 0.1, true, false, false, false};

    ObjectDrag begin(Grip grip, Vec3 at) const {
        return *ObjectDrag::begin(scene, {lamp.object}, grip, ray(eye, at), 100.0, snap);
    }
    Vec3 place(const Scene& after) const { return *place_of(after, lamp.object); }
};

TEST(Dragging, keeps_the_grip_where_the_object_was_taken_hold_of) {
    const Dragging a;
    ObjectDrag drag = a.begin(Grip::plane_xy, a.start + Vec3(0.2, 0.1, 0.0));
    const Vec3 place = a.place(drag.at(ray(eye, a.start + Vec3(1.2, 0.6, 0.0)), {}, 0.1));
    EXPECT_NEAR(place.x, a.start.x + 1.0, exact);
    EXPECT_NEAR(place.y, a.start.y + 0.5, exact);
    EXPECT_EQ(place.z, a.start.z);
    EXPECT_EQ(drag.step(), "Move luminaire");
}

TEST(Dragging, by_an_arrow_changes_that_coordinate_alone) {
    const Dragging a;
    ObjectDrag drag = a.begin(Grip::z, a.start + Vec3(0.0, 0.0, 0.3));
    const Vec3 place = a.place(drag.at(ray(eye, a.start + Vec3(0.0, 0.0, 0.9)), {}, 0.1));
    EXPECT_EQ(place.x, a.start.x);
    EXPECT_EQ(place.y, a.start.y);
    EXPECT_NEAR(place.z, a.start.z + 0.6, exact);
}

TEST(Dragging, keeps_to_the_raster_and_leaves_the_height_alone) {
    Dragging a;
    a.snap.on = true;
    ObjectDrag drag = a.begin(Grip::plane_xy, a.start);
    const Ray to = ray(eye, a.start + Vec3(0.533, 0.27, 0.0));
    const Vec3 place = a.place(drag.at(to, {}, 0.1));
    EXPECT_NEAR(place.x, 3.5, exact);
    EXPECT_NEAR(place.y, 2.3, exact);
    EXPECT_EQ(place.z, a.start.z);
    ObjectDrag::Keys control;
    control.frees = true;
    EXPECT_NEAR(a.place(drag.at(to, control, 0.1)).x, a.start.x + 0.533, exact) << "Ctrl frees it";
}

TEST(Dragging, with_a_key_keeps_to_one_axis_until_it_is_pressed_again) {
    const Dragging a;
    ObjectDrag drag = a.begin(Grip::plane_xy, a.start);
    ObjectDrag::Keys x;
    x.axis = Axis::x;
    drag.at(ray(eye, a.start), x, 0.1);
    Vec3 place = a.place(drag.at(ray(eye, a.start + Vec3(1.0, 0.0, 0.0)), {}, 0.1));
    EXPECT_NEAR(place.x, a.start.x + 1.0, exact);
    EXPECT_EQ(place.y, a.start.y);
    drag.at(ray(eye, a.start), x, 0.1);
    place = a.place(drag.at(ray(eye, a.start + Vec3(1.0, 1.0, 0.0)), {}, 0.1));
    EXPECT_NEAR(place.y, a.start.y + 1.0, exact);
}

TEST(Dragging, a_typed_figure_says_how_far_it_goes) {
    const Dragging a;
    ObjectDrag drag = a.begin(Grip::x, a.start);
    ObjectDrag::Keys keys;
    keys.letters = "1.2";
    drag.at(ray(eye, a.start), keys, 0.1);
    keys.letters = "5";
    EXPECT_NEAR(a.place(drag.at(ray(eye, a.start), keys, 0.1)).x, a.start.x + 1.25, exact);
    EXPECT_TRUE(drag.fault().empty());
    keys = {};
    keys.erases = true;
    EXPECT_NEAR(a.place(drag.at(ray(eye, a.start), keys, 0.1)).x, a.start.x + 1.2, exact) << "Backspace";
    keys = {};
    keys.letters = "*";
    EXPECT_EQ(a.place(drag.at(ray(eye, a.start), keys, 0.1)), a.start) << "no figure yet";
    EXPECT_FALSE(drag.fault().empty());
}

TEST(Dragging, two_typed_figures_are_x_and_y) {
    const Dragging a;
    ObjectDrag drag = a.begin(Grip::plane_xy, a.start);
    ObjectDrag::Keys keys;
    keys.letters = "0.5; -30cm";
    const Vec3 place = a.place(drag.at(ray(eye, a.start + Vec3(9.0, 0.0, 0.0)), keys, 0.1));
    EXPECT_NEAR(place.x, a.start.x + 0.5, exact);
    EXPECT_NEAR(place.y, a.start.y - 0.3, exact);
}

TEST(Dragging, the_ring_turns_what_is_chosen_about_its_middle) {
    Dragging a;
    a.snap.on = true;
    ObjectDrag drag = a.begin(Grip::turn, a.start + Vec3(1.0, 0.0, 0.0));
    const double angle = 0.52;  // rad, nearest to 30 degrees of the raster of 15
    const Scene after = drag.at(ray(eye, a.start + Vec3(std::cos(angle), std::sin(angle), 0.0)), {}, 0.1);
    EXPECT_NEAR(after.luminaires.front().yaw, std::numbers::pi / 6.0, exact);
    EXPECT_EQ(a.place(after), a.start);
    EXPECT_EQ(drag.step(), "Turn luminaire");
    ObjectDrag::Keys keys;
    keys.letters = "45";
    EXPECT_NEAR(drag.at(ray(eye, a.start), keys, 0.1).luminaires.front().yaw, std::numbers::pi / 4.0, exact);
}

TEST(Dragging, what_has_no_place_or_is_seen_end_on_cannot_be_dragged) {
    const Dragging a;
    const ObjectId room = a.scene->room->id;
    EXPECT_FALSE(ObjectDrag::begin(a.scene, {room}, Grip::plane_xy, ray(eye, a.start), 100.0, a.snap));
    const Ray along = ray(a.start + Vec3(0.0, 0.0, 5.0), a.start);
    EXPECT_FALSE(ObjectDrag::begin(a.scene, {a.lamp.object}, Grip::z, along, 100.0, a.snap));
}

/// Lines that catch, by axis.
std::vector<double> values(const std::vector<SnapLine>& lines, int axis, SnapKind kind) {
    std::vector<double> found;
    for (const SnapLine& line : lines)
        if (line.axis == axis && line.kind == kind) found.push_back(line.value);
    std::sort(found.begin(), found.end());
    return found;
}

TEST(Snapping, furniture_touches_walls_and_the_middle_of_the_room) {
    const Added box = with_box(empty_room());  // 1.2 m x 0.6 m in a room of 6 m x 4 m
    const Vec3 place = *place_of(box.scene, box.object);
    const auto lines = snap_lines(box.scene, std::array{box.object}, place, {});
    const std::vector<double> x = values(lines, 0, SnapKind::wall), y = values(lines, 1, SnapKind::wall);
    ASSERT_EQ(x.size(), 2U);
    EXPECT_NEAR(x[0], 0.6, exact);
    EXPECT_NEAR(x[1], 5.4, exact);
    ASSERT_EQ(y.size(), 2U);
    EXPECT_NEAR(y[0], 0.3, exact);
    EXPECT_NEAR(y[1], 3.7, exact);
    EXPECT_EQ(values(lines, 0, SnapKind::centre), std::vector<double>{3.0});
}

TEST(Snapping, a_luminaire_catches_at_others_and_at_half_its_spacing_from_the_wall) {
    Added first = with_point_luminaire(empty_room());
    const Added second = with_point_luminaire(moved(first.scene, first.object, {0.0, 1.0, 0.0}));
    const Vec3 place = *place_of(second.scene, second.object);
    const auto lines = snap_lines(second.scene, std::array{second.object}, place, {});
    EXPECT_EQ(values(lines, 1, SnapKind::object), std::vector<double>{3.0});
    const std::vector<double> half = values(lines, 1, SnapKind::half_spacing);
    ASSERT_EQ(half.size(), 2U);
    EXPECT_NEAR(half[0], 1.0, exact) << "1 m from the wall, 2 m from the other";
    const bool all[3] = {true, true, true};
    const Snapped caught = snapped({2.97, 2.95, 1.234}, lines, {}, 0.08, all);
    EXPECT_NEAR(glm::distance(caught.place, Vec3(3.0, 3.0, 1.2)), 0.0, exact);
    EXPECT_EQ(caught.caught.size(), 2U);
    EXPECT_EQ(snapped({2.5, 2.5, 1.0}, lines, {}, 0.0, all).caught.size(), 0U);
}

}  // namespace
}  // namespace hanei
