#include "ui/view/camera_passage.h"

#include "ui/view/standpoint.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace hanei {
namespace {

const Bounds room{{0.0, 0.0, 0.0}, {8.0, 5.0, 3.0}};
Camera at(Standpoint standpoint) { return camera_at(standpoint, room, 1.5); }

TEST(CameraPassage, ends_exactly_where_it_should) {
    for (const Standpoint to : standpoints) {
        if (to == Standpoint::ceiling_plan) continue;
        EXPECT_TRUE(between(at(Standpoint::overview), at(to), 1.0) == at(to));
    }
}

/// The greatest change of the picture's own axes from one of 200 steps to the next.
double greatest_turn(const Camera& from, const Camera& to) {
    double greatest = 0.0;
    CameraAxes before = axes_of(between(from, to, 0.0));
    for (int k = 1; k <= 200; ++k) {
        const CameraAxes now = axes_of(between(from, to, k / 200.0));
        greatest = std::max({greatest, glm::distance(before.right, now.right), glm::distance(before.up, now.up)});
        before = now;
    }
    return greatest;
}

TEST(CameraPassage, turns_the_picture_without_a_jump) {
    for (const Standpoint from : standpoints) {
        for (const Standpoint to : standpoints) {
            if (!can_glide(at(from), at(to))) continue;
            // Half a turn in 200 steps is 0.016 rad each; twice that near the pole.
            EXPECT_LT(greatest_turn(at(from), at(to)), 0.04) << name_of(from) << " to " << name_of(to);
        }
    }
}

TEST(CameraPassage, becomes_parallel_without_a_jump_in_size) {
    const Camera from = at(Standpoint::overview), to = at(Standpoint::plan);
    const Vec3 corner{8.0, 5.0, 0.0};
    Vec2 before = *projected(between(from, to, 0.0), corner, 1.5);
    for (int k = 1; k <= 200; ++k) {
        const Vec2 now = *projected(between(from, to, k / 200.0), corner, 1.5);
        EXPECT_LT(glm::distance(before, now), 0.03) << k;  // of the picture
        before = now;
    }
}

TEST(CameraPassage, takes_the_shorter_way_around) {
    Camera from = at(Standpoint::overview), to = from;
    from.eye = from.target + Vec3(-5.0, 0.5, 2.0);
    to.eye = to.target + Vec3(-5.0, -0.5, 2.0);
    EXPECT_LT(between(from, to, 0.5).eye.x, to.target.x - 4.0);
}

TEST(CameraPassage, has_no_way_into_a_mirror_or_from_no_direction) {
    EXPECT_FALSE(can_glide(at(Standpoint::overview), at(Standpoint::ceiling_plan)));
    EXPECT_FALSE(can_glide(Camera{}, at(Standpoint::plan)));
    EXPECT_TRUE(can_glide(at(Standpoint::plan), at(Standpoint::left)));
}

}  // namespace
}  // namespace hanei
