#include "ui/view/value_labels.h"

#include "tests/unit/view/room_by_hand.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace hanei {
namespace {

using namespace test;

constexpr PixelSize size{1000, 700};

/// The furnished room with a fine grid at desk height, a pin on the floor and one under a desk.
std::shared_ptr<Solution> valued_room(double spacing) {
    Scene scene = furnished_room();
    scene.grids.clear();
    scene.points.clear();
    auto solution = std::make_shared<Solution>(*solution_by_hand(scene, pleasant_light));
    CalculationGrid grid;
    grid.id = ObjectId{900};
    grid.corner = {0.5, 0.5, 0.85};
    grid.along = {5.0, 0.0, 0.0};
    grid.across = {0.0, 3.0, 0.0};
    grid.spacing = spacing;
    GridResult result = layout_of(grid);
    result.grid = grid.id;
    for (std::size_t k = 0; k < result.points.size(); ++k)
        result.points[k].value.direct = {100.0 + static_cast<double>(k)};
    solution->grids = {result};
    PointResult pin;
    pin.point = ObjectId{901};
    pin.position = {3.0, 0.4, 0.0};
    pin.value.direct = {412.0};
    pin.value.error.mesh = 3.0;
    solution->points = {pin};
    return solution;
}

ViewOptions valued() {
    ViewOptions look;
    look.values = look.pins = true;
    return look;
}

Camera from_above(const Solution& solution) { return plan_view(bounds_of(*solution.scene), size.aspect()); }

std::size_t count(const std::vector<ValueLabel>& labels, ValueLabel::Kind kind) {
    return static_cast<std::size_t>(
        std::count_if(labels.begin(), labels.end(), [&](const ValueLabel& label) { return label.kind == kind; }));
}

TEST(ValueLabels, never_cover_each_other_nor_the_border) {
    for (const double spacing : {0.1, 0.25, 1.0}) {
        const auto solution = valued_room(spacing);
        for (const double scale : {1.0, 2.0}) {
            const auto labels = value_labels(*solution, from_above(*solution), valued(), size, scale);
            EXPECT_FALSE(labels.empty());
            for (std::size_t a = 0; a < labels.size(); ++a) {
                const Vec2 at = labels[a].at * Vec2(size.width, size.height), half = half_size(labels[a], scale);
                EXPECT_TRUE(at.x >= half.x && at.y >= half.y && at.x <= size.width - half.x &&
                            at.y <= size.height - half.y);
                for (std::size_t b = a + 1; b < labels.size(); ++b) {
                    const Vec2 apart = glm::abs(at - labels[b].at * Vec2(size.width, size.height));
                    const Vec2 room = half + half_size(labels[b], scale);
                    EXPECT_TRUE(apart.x >= room.x - 1e-6 || apart.y >= room.y - 1e-6)
                        << labels[a].text << " and " << labels[b].text;
                }
            }
        }
    }
}

TEST(ValueLabels, thin_a_grid_by_whole_rows_and_show_the_chosen_one_as_full_as_they_can) {
    const auto solution = valued_room(0.1);
    ViewOptions look = valued();
    const auto thinned = value_labels(*solution, from_above(*solution), look, size);
    look.values_of = ObjectId{900};
    const auto full = value_labels(*solution, from_above(*solution), look, size);
    EXPECT_GT(count(thinned, ValueLabel::Kind::figure), 20U);
    EXPECT_GT(count(full, ValueLabel::Kind::figure), count(thinned, ValueLabel::Kind::figure));
    const auto wide = valued_room(1.0);
    const auto all = value_labels(*wide, from_above(*wide), look, size);
    EXPECT_EQ(all.size(), 15U + 1U) << "5 x 3 figures, three of them marked, and the pin";
}

TEST(ValueLabels, mark_the_least_the_greatest_and_the_mean_of_a_grid) {
    const auto solution = valued_room(0.25);
    const auto labels = value_labels(*solution, from_above(*solution), valued(), size);
    const double last = 100.0 + static_cast<double>(solution->grids.front().points.size() - 1);
    for (const auto& [kind, text] :
         {std::pair{ValueLabel::Kind::least, std::string("min 100")},
          std::pair{ValueLabel::Kind::greatest, "max " + value_text(last, {})},
          std::pair{ValueLabel::Kind::middle, "mean " + value_text(0.5 * (100.0 + last), {})}}) {
        const auto found =
            std::find_if(labels.begin(), labels.end(), [&](const auto& label) { return label.kind == kind; });
        ASSERT_NE(found, labels.end()) << text;
        EXPECT_EQ(found->text, text);
    }
}

TEST(ValueLabels, say_how_wrong_a_pin_can_be_in_the_unit_that_is_shown) {
    const auto solution = valued_room(1.0);
    ViewOptions look = valued();
    look.values = false;
    auto labels = value_labels(*solution, from_above(*solution), look, size);
    ASSERT_EQ(labels.size(), 1U);
    EXPECT_EQ(labels.front().text, "412 ± 3 lx");
    look.unit = IlluminanceUnit::foot_candle;
    labels = value_labels(*solution, from_above(*solution), look, size);
    EXPECT_EQ(labels.front().text, "38.3 ± 0.28 fc");
}

TEST(ValueLabels, leave_out_what_stands_behind_something) {
    const auto solution = valued_room(1.0);
    solution->points.front().position = solution->scene->furniture.front().position + Vec3(0.0, 0.0, 0.01);
    ViewOptions look = valued();
    look.values = false;
    EXPECT_TRUE(value_labels(*solution, from_above(*solution), look, size).empty()) << "under the desk's top";
}

TEST(ValueLabels, are_none_of_a_part_that_values_do_not_have) {
    const auto solution = valued_room(1.0);
    ViewOptions look = valued();
    look.part = LightPart::unshadowed;
    EXPECT_TRUE(value_labels(*solution, from_above(*solution), look, size).empty());
}

}  // namespace
}  // namespace hanei
