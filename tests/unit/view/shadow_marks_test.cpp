#include "ui/view/shadow_marks.h"

#include "room_by_hand.h"
#include "ui/view/legend.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

/// The furnished room with a shadow of one luminaire, by hand.
Solution with_shadows() {
    Solution solution = *test::solution_by_hand(test::furnished_room(), test::pleasant_light);
    auto shadows = std::make_shared<Shadows>();
    std::vector<LightClass> classes(solution.mesh->patches.size(), LightClass::lit);
    classes[0] = LightClass::partly;
    shadows->luminaires.push_back({solution.scene->luminaires[0].id, classes, {}});
    shadows->luminaires[0].lines = {{{{1, 1, 0}, {3, 1, 0}, {3, 2, 0}}, 0, true}, {{{1, 0, 0}, {4, 0, 0}}, 0, false}};
    solution.shadows = shadows;
    return solution;
}

TEST(ShadowMarks, umbrae_are_whole_lines_and_penumbrae_dashes_each_on_a_pale_ground) {
    const Solution solution = with_shadows();
    double solid = 0.0, dashed = 0.0, pale = 0.0;
    for (const LineMark& line : shadow_lines(solution, ObjectId{})) {
        const double length = glm::distance(line.from, line.to);
        (line.colour.r > 0.5F ? pale : line.from.y > 0.5 ? solid : dashed) += length;
    }
    EXPECT_NEAR(solid, 3.0, 1e-9);
    EXPECT_NEAR(dashed / 3.0, 0.6, 0.02);  // the last dash may be cut
    EXPECT_NEAR(pale, solid + dashed, 1e-9);
}

TEST(ShadowMarks, of_another_luminaire_there_are_none_of_its_own) {
    Solution solution = with_shadows();
    auto shadows = std::make_shared<Shadows>(*solution.shadows);
    shadows->luminaires.push_back({ObjectId{123}, shadows->luminaires[0].classes, {}});
    solution.shadows = shadows;
    EXPECT_TRUE(shadow_lines(solution, ObjectId{123}).empty());
    EXPECT_FALSE(shadow_lines(solution, ObjectId{}).empty());
}

TEST(ShadowMarks, partly_lit_patches_are_hatched_and_no_others) {
    const Solution solution = with_shadows();
    std::size_t hatched = 0, all = 0;
    for (const SolidVertex& vertex : class_marks(solution, ObjectId{})) {
        ++all;
        hatched += vertex.colour.a < 0.5F ? 1 : 0;
    }
    EXPECT_EQ(hatched, 3 * (solution.mesh->patches[0].outline.size() - 2));
    EXPECT_GT(all, hatched);
}

TEST(ShadowMarks, classes_differ_in_lightness) {
    const auto lightness = [](LightClass kind) { return class_colours[static_cast<std::size_t>(kind)].g; };
    EXPECT_GT(lightness(LightClass::lit), lightness(LightClass::partly) + 0.1F);
    EXPECT_GT(lightness(LightClass::partly), lightness(LightClass::away) + 0.2F);
    EXPECT_GT(lightness(LightClass::away), lightness(LightClass::umbra) + 0.2F);
}

TEST(ShadowMarks, the_key_counts_patches_and_names_the_luminaire) {
    const Solution solution = with_shadows();
    ViewOptions look;
    look.shadow_classes = true;
    const std::vector<ClassRow> rows = class_rows(&solution, look);
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_EQ(rows[1].counts.substr(0, 8), "1 patch,");
    EXPECT_TRUE(class_rows(nullptr, look)[0].counts.empty());
    EXPECT_EQ(shadows_of_text(*solution.scene, ObjectId{}), "all luminaires");
    EXPECT_NE(shadows_of_text(*solution.scene, solution.scene->luminaires[0].id), "all luminaires");
    EXPECT_EQ(class_legend_image(solution, look, 600).width, class_legend_width());
}

}  // namespace
}  // namespace hanei
