/// What is computed of direct light and of the balance after an edit, counted.
#include "engine/study/direct_stage.h"
#include "engine/study/light_groups.h"
#include "engine/study/light_sides.h"
#include "tests/unit/study/runs.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

namespace hanei {
namespace {

/// Direct light on a row of floor points of the office, and how many points each luminaire was computed at.
class KeptDirectLight : public testing::Test {
protected:
    KeptDirectLight() {
        for (int k = 0; k < 40; ++k) floor_.push_back({{0.075 + 0.15 * k, 0.2, 0.0}, {0.0, 0.0, 1.0}, Vec3{0.0}});
        receivers_.identity = std::make_shared<const int>();
        receivers_.count = floor_.size();
        receivers_.places = [this](std::size_t k) { return std::span(&floor_[k].position, 1); };
    }
    std::vector<double> light(const Scene& scene, DirectStage& stage) {
        counts_.clear();
        const auto occluders = std::make_shared<const OccluderSet>(occluders_of(scene));
        receivers_.compute = [&](const Emitter& emitter, std::span<const std::uint32_t> which) {
            counts_.push_back(which.size());
            std::vector<Receiver> some;
            for (const std::uint32_t k : which) some.push_back(floor_[k]);
            return direct_illuminance(emitter, some, occluders.get(), Work{});
        };
        return *stage.sum(scene, receivers_, occluders);
    }
    std::vector<double> light(const Scene& scene) { return light(scene, stage_); }
    void expect_as_fresh(const Scene& scene, const std::vector<double>& got) {
        DirectStage fresh;
        EXPECT_EQ(got, light(scene, fresh));
    }

    DirectStage stage_;
    std::vector<Receiver> floor_;
    LightReceivers receivers_;
    std::vector<std::size_t> counts_;  ///< receivers of each luminaire that was computed
};

/// The office with six boxes, so that one is less than half of the bodies.
Scene office_of_boxes() {
    Scene scene = test::small_office();
    for (int k = 0; k < 5; ++k) scene.furniture.push_back(test::box(scene, {0.6 + k, 3.4, 0.0}, {0.5, 0.5, 0.7}));
    return scene;
}

TEST_F(KeptDirectLight, a_moved_luminaire_is_computed_alone) {
    Scene scene = office_of_boxes();
    light(scene);
    EXPECT_EQ(counts_.size(), 2U);
    scene.luminaires.front().position.x += 0.5;
    const auto moved = light(scene);
    EXPECT_EQ(counts_, std::vector{floor_.size()});
    expect_as_fresh(scene, moved);
}

TEST_F(KeptDirectLight, other_photometry_is_computed_alone) {
    Scene scene = test::grouped_office();
    light(scene);
    scene.photometries.front().candela[2] *= 2.0;
    const auto other = light(scene);
    EXPECT_EQ(counts_, std::vector{floor_.size()});
    expect_as_fresh(scene, other);
}

TEST_F(KeptDirectLight, a_moved_box_is_looked_at_only_where_its_shadow_can_fall) {
    Scene scene = office_of_boxes();
    light(scene);
    scene.furniture.front().position.y = 1.0;
    const auto moved = light(scene);
    const auto computed = std::accumulate(counts_.begin(), counts_.end(), std::size_t{0});
    EXPECT_GT(computed, 0U);
    EXPECT_LT(computed, floor_.size());  // of twice as many: two luminaires
    expect_as_fresh(scene, moved);
}

TEST_F(KeptDirectLight, a_box_moved_far_from_all_shadows_costs_nothing) {
    Scene scene = office_of_boxes();
    light(scene);
    scene.furniture.back().position.y -= 0.1;
    const auto moved = light(scene);
    EXPECT_TRUE(counts_.empty());
    expect_as_fresh(scene, moved);
}

TEST_F(KeptDirectLight, dimming_computes_no_luminaire) {
    Scene scene = office_of_boxes();
    light(scene);
    scene.luminaires.front().dimming = 0.3;
    const auto dimmed = light(scene);
    EXPECT_TRUE(counts_.empty());
    expect_as_fresh(scene, dimmed);
}

/// Three unknowns that send a tenth of their light to each other, and how many sides were multiplied.
class KeptSides : public testing::Test {
protected:
    std::vector<SideInput> inputs() const {
        std::vector<SideInput> inputs;
        for (unsigned group = 1; group <= 3; ++group) {
            SideInput& input = inputs.emplace_back();
            input.name = {ObjectId{group}, 0};
            input.direct = {direct_};
            input.shares = {1.0 / group};
            input.reflectance = {0.5, 0.6, 0.7};
            input.rows = rows_;
        }
        return inputs;
    }
    std::vector<std::shared_ptr<const SideLight>> get(std::vector<SideInput> inputs) {
        solved_ = 0;
        const Exchange exchange = [this](std::span<const double> leaving, std::span<double> arriving,
                                         std::size_t sides) {
            solved_ += sides;
            for (std::size_t s = 0; s < sides; ++s) {
                const double sum = leaving[s] + leaving[sides + s] + leaving[2 * sides + s];
                for (std::size_t k = 0; k < 3; ++k) arriving[k * sides + s] = 0.1 * sum;
            }
            return true;
        };
        const std::vector<double> areas(3, 1.0), row_sums(3, 0.3);
        return *sides_.get(std::move(inputs), {exchange, areas, row_sums}, false, Work{});
    }

    LightSides sides_;
    std::shared_ptr<const std::vector<double>> direct_ =
        std::make_shared<const std::vector<double>>(std::vector{100.0, 200.0, 300.0});
    std::shared_ptr<const void> rows_ = std::make_shared<const int>();
    std::size_t solved_ = 0;  ///< sides in all products
};

TEST_F(KeptSides, what_is_as_it_was_is_not_solved) {
    const auto first = get(inputs());
    EXPECT_GE(solved_, 3U);
    const auto again = get(inputs());
    EXPECT_EQ(solved_, 0U);
    EXPECT_TRUE(sides_.reused());
    EXPECT_EQ(first, again);
}

TEST_F(KeptSides, a_group_whose_member_was_dimmed_is_solved_alone) {
    const auto first = get(inputs());
    const std::size_t solved_first = solved_;
    auto dimmed = inputs();
    dimmed[1].shares = {0.2};
    const auto second = get(dimmed);
    EXPECT_FALSE(sides_.reused());
    EXPECT_EQ(second[0], first[0]);
    EXPECT_NE(second[1], first[1]);
    EXPECT_EQ(second[2], first[2]);
    EXPECT_LT(solved_, solved_first);
}

TEST_F(KeptSides, other_rows_or_reflectances_solve_every_group) {
    const auto first = get(inputs());
    rows_ = std::make_shared<const int>();
    const auto second = get(inputs());
    for (std::size_t group = 0; group < first.size(); ++group) EXPECT_NE(second[group], first[group]);
    auto painted = inputs();
    for (SideInput& input : painted) input.reflectance = {0.1, 0.1, 0.1};
    const auto third = get(painted);
    for (std::size_t group = 0; group < first.size(); ++group) EXPECT_NE(third[group], second[group]);
}

TEST(LightGroups, one_member_dimmed_leaves_the_groups_level) {
    Scene scene = test::grouped_office();
    scene.luminaires[2].dimming = 0.5;
    const auto groups = light_groups(scene);
    ASSERT_EQ(groups.size(), 4U);  // "wall", two luminaires by themselves, the surfaces
    EXPECT_EQ(groups[0].level, 1.0);
    EXPECT_EQ(groups[0].members[0].share, 0.5);
    EXPECT_EQ(groups[0].members[1].share, 1.0);
    EXPECT_TRUE(groups.back().members.empty());
}

}  // namespace
}  // namespace hanei
