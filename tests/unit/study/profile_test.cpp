#include "engine/study/profile.h"

#include "engine/study/study.h"
#include "tests/unit/study/runs.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace hanei {
namespace {

using namespace test;

ProfileSampler finished(const SolutionSnapshot& solution, const ProfileLine& line) {
    ProfileSampler profile(solution, line);
    while (!profile.done()) profile.advance(50);
    return profile;
}

SolutionSnapshot office_with_a_point_source() {
    Scene scene = small_office();
    scene.luminaires = {point_source(scene, {2.0, 2.0, 2.6}, 3000.0)};
    return Study().run(snapshot(scene), coarse_settings(), {}, Work{});
}

TEST(Profile, runs_from_end_to_end_in_order_and_gathers_every_value_itself) {
    const SolutionSnapshot solution = office_with_a_point_source();
    const ProfileLine line{{0.5, 1.0, 0.0}, {5.5, 1.0, 0.0}, {0.0, 0.0, 2.0}};
    const ProfileSampler profile = finished(solution, line);
    ASSERT_GE(profile.samples().size(), 97U);
    EXPECT_EQ(profile.samples().front().along, 0.0);
    EXPECT_EQ(profile.samples().back().along, 5.0);
    for (std::size_t k = 1; k < profile.samples().size(); ++k)
        EXPECT_LT(profile.samples()[k - 1].along, profile.samples()[k].along);
    const ProfileSample& some = profile.samples()[40];
    EXPECT_EQ(some.value.total().value, value_at(*solution, line.at(some.along), {0.0, 0.0, 1.0}).total().value);
}

TEST(Profile, shows_the_edge_of_a_hard_shadow_as_a_step) {
    const SolutionSnapshot solution = office_with_a_point_source();
    // the desk, 0.72 high and 1.6 long, shades the floor from x = 0.89 on: 2.0 - 0.8 x 2.6 / (2.6 - 0.72)
    const ProfileSampler profile = finished(solution, {{0.2, 2.0, 0.0}, {1.15, 2.0, 0.0}, {0.0, 0.0, 1.0}});
    const double edge = 2.0 - 0.8 * 2.6 / 1.88;
    double before = -1.0, after = -1.0;
    for (const ProfileSample& sample : profile.samples()) {
        if (sample.value.direct.value > 0.0)
            before = std::max(before, sample.along + 0.2);
        else if (after < 0.0)
            after = sample.along + 0.2;
    }
    EXPECT_LT(after - before, 1e-3) << "within a millimetre";
    EXPECT_NEAR(0.5 * (after + before), edge, 1e-3);
}

TEST(Profile, of_no_length_has_no_values) {
    ProfileSampler profile(office_with_a_point_source(), {{1.0, 1.0, 0.0}, {1.0, 1.0, 0.0}, {0.0, 0.0, 0.0}});
    EXPECT_TRUE(profile.done());
    profile.advance(10);
    EXPECT_TRUE(profile.samples().empty());
}

TEST(Profile, tells_where_it_passes_through_furniture) {
    const ProfileSampler profile =
        finished(office_with_a_point_source(), {{0.5, 2.0, 0.3}, {4.0, 2.0, 0.3}, {0.0, 0.0, 1.0}});
    EXPECT_TRUE(std::any_of(profile.samples().begin(), profile.samples().end(),
                            [](const ProfileSample& sample) { return sample.value.inside_solid; }));
    EXPECT_LE(profile.samples().size(), 400U);
}

}  // namespace
}  // namespace hanei
