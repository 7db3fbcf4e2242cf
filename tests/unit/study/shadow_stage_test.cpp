#include "engine/study/study.h"
#include "tests/box_room.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace hanei {
namespace {

SolutionSnapshot solved(Study& study, const Scene& scene, bool shadows = true) {
    Settings settings;
    settings.max_patch = 0.8;
    settings.threads = 1;
    return study.run(std::make_shared<const Scene>(scene), settings, {.shadows = shadows, .mesh_error = false}, Work{});
}

TEST(ShadowStage, shadows_are_worked_out_when_they_are_asked_for) {
    Study study;
    EXPECT_EQ(solved(study, test::small_office(), false)->shadows, nullptr);
    const auto solution = solved(study, test::small_office());
    ASSERT_NE(solution->shadows, nullptr);
    ASSERT_EQ(solution->shadows->luminaires.size(), solution->scene->luminaires.size());
    for (const LuminaireShadows& luminaire : solution->shadows->luminaires) {
        EXPECT_EQ(luminaire.classes.size(), solution->mesh->patches.size());
        EXPECT_FALSE(luminaire.lines.empty());
    }
}

TEST(ShadowStage, dimming_and_paint_leave_the_shadows_alone_and_a_moved_luminaire_does_not) {
    Study study;
    Scene scene = test::small_office();
    const auto first = solved(study, scene);
    scene.luminaires[0].dimming = 0.3;
    scene.materials[0].reflectance = 0.11;
    EXPECT_EQ(solved(study, scene)->shadows, first->shadows);
    scene.luminaires[0].position.x += 0.2;
    EXPECT_NE(solved(study, scene)->shadows, first->shadows);
}

TEST(ShadowStage, a_luminaire_that_is_off_has_no_shadows) {
    Study study;
    Scene scene = test::small_office();
    scene.luminaires[0].dimming = 0.0;
    EXPECT_FALSE(holds(*solved(study, scene)->shadows, scene.luminaires[0].id));
}

TEST(ShadowStage, patches_proved_lit_or_unlit_have_the_mean_that_says_so) {
    Study study;
    const auto solution = solved(study, test::small_office());
    const auto classes = patch_classes(*solution->shadows, ObjectId{}, solution->mesh->patches.size());
    int lit = 0;
    for (std::size_t p = 0; p < classes.size(); ++p) {
        if (is_unlit(classes[p])) {
            EXPECT_EQ(solution->patch_direct[p], 0.0);
        }
        if (classes[p] == LightClass::lit) {
            EXPECT_GT(solution->patch_direct[p], 0.0);
            ++lit;
        }
    }
    EXPECT_GT(lit, 0);
}

}  // namespace
}  // namespace hanei
