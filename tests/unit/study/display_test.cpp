#include "engine/scene/colour.h"
#include "engine/study/study.h"
#include "tests/box_room.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <map>

namespace hanei {
namespace {

constexpr double rounding = 1e-5;  // of floats, relative

Settings settings_of_tests() {
    Settings settings;
    settings.max_patch = 0.8;
    settings.threads = 1;
    return settings;
}

/// Displays of one study that follows a scene while it is edited.
class Shown {
public:
    SolutionSnapshot show(const Scene& scene, bool live = false) {
        const StudyRequest request{.display = true, .live = live, .mesh_error = false};
        return study_.run(std::make_shared<const Scene>(scene), settings_of_tests(), request, Work{});
    }

private:
    Study study_;
};

void expect_same_picture(const DisplayMesh& a, const DisplayMesh& b) {
    ASSERT_EQ(a.cells.size(), b.cells.size());
    ASSERT_EQ(a.vertices.size(), b.vertices.size());
    for (std::size_t k = 0; k < a.vertices.size(); ++k) {
        EXPECT_EQ(a.vertices[k].position, b.vertices[k].position);
        EXPECT_NEAR(a.vertices[k].direct, b.vertices[k].direct, rounding * (1.0 + b.vertices[k].direct));
        EXPECT_NEAR(a.vertices[k].interreflected, b.vertices[k].interreflected,
                    1e-3 * (1.0 + b.vertices[k].interreflected));  // solved from another start
    }
}

/// The picture after an edit, by a study that showed the scene before and while it was edited, against
/// a study that sees it first.
void expect_as_computed_anew(const std::function<void(Scene&, double share)>& edit) {
    Scene scene = test::small_office();
    Shown followed;
    ASSERT_TRUE(followed.show(scene));
    for (const double share : {0.25, 0.5, 1.0}) {
        scene = test::small_office();
        edit(scene, share);
        ASSERT_TRUE(followed.show(scene, true));
    }
    expect_same_picture(*followed.show(scene)->display, *Shown().show(scene)->display);
}

TEST(Display, of_a_dimmed_luminaire_is_as_computed_anew) {
    expect_as_computed_anew([](Scene& scene, double share) { scene.luminaires.front().dimming = 1.0 - 0.9 * share; });
}

TEST(Display, of_a_dragged_luminaire_is_as_computed_anew) {
    expect_as_computed_anew([](Scene& scene, double share) { scene.luminaires.front().position.x += 0.7 * share; });
}

TEST(Display, of_dragged_furniture_is_as_computed_anew) {
    expect_as_computed_anew([](Scene& scene, double share) { scene.furniture.front().position.x += 0.4 * share; });
}

TEST(Display, keeps_its_cells_while_a_luminaire_is_dragged) {
    Scene scene = test::small_office();
    Shown followed;
    const auto before = followed.show(scene);
    scene.luminaires.front().position.x += 0.5;
    const auto during = followed.show(scene, true);
    ASSERT_EQ(before->display->vertices.size(), during->display->vertices.size());
    double most = 0.0;
    for (std::size_t k = 0; k < before->display->vertices.size(); ++k) {
        EXPECT_EQ(before->display->vertices[k].position, during->display->vertices[k].position);
        most = std::max(most, std::abs(static_cast<double>(before->display->vertices[k].direct) -
                                       static_cast<double>(during->display->vertices[k].direct)));
    }
    EXPECT_GT(most, 1.0) << "its light moved with it";
}

TEST(Display, of_a_luminaire_under_way_hardly_anywhere_differs_from_the_exact_one_by_more_than_is_seen) {
    Scene scene = test::small_office();
    Shown followed;
    followed.show(scene);
    scene.luminaires.front().position.x += 0.4;
    const auto rough = followed.show(scene, true);
    const auto anew = Shown().show(scene);
    const auto key = [](const Vec3& place) { return std::array{place.x, place.y, place.z}; };
    std::map<std::array<double, 3>, std::vector<float>> lit;  // several where faces meet
    float brightest = 0.0F;
    for (const DisplayVertex& vertex : anew->display->vertices) {
        lit[key(vertex.position)].push_back(vertex.direct);
        brightest = std::max(brightest, vertex.direct);
    }
    int compared = 0, seen = 0;
    for (const DisplayVertex& vertex : rough->display->vertices) {
        const auto found = lit.find(key(vertex.position));
        if (found == lit.end() || found->second.size() > 1) continue;
        const float exact = found->second.front();
        if (std::abs(vertex.direct - exact) > 0.09F * exact + 0.01F * brightest) ++seen;
        ++compared;
    }
    EXPECT_GT(compared, 1000);
    EXPECT_LE(seen, compared / 200) << "a narrow shadow may fall between corners that are lit alike";
}

TEST(Display, of_a_dimmed_luminaire_lights_nothing_anew) {
    Scene scene = test::small_office();
    Shown followed;
    followed.show(scene);
    scene.luminaires.front().dimming = 0.3;
    const auto dimmed = followed.show(scene, true);
    const auto refining = std::find_if(dimmed->times.begin(), dimmed->times.end(),
                                       [](const StageTime& time) { return time.stage == Stage::refining; });
    ASSERT_NE(refining, dimmed->times.end());
    EXPECT_TRUE(refining->reused);
}

TEST(Display, of_a_scene_let_go_has_the_same_figures_as_computed_anew_and_a_mesh_error_all_the_while) {
    Scene scene = test::small_office();
    Study study;
    const auto run = [&](Study& by, bool live) {
        const StudyRequest request{.display = true, .live = live, .mesh_error = !live};
        return by.run(std::make_shared<const Scene>(scene), settings_of_tests(), request, Work{});
    };
    run(study, false);
    scene.luminaires.front().position.x += 0.4;
    const auto dragged = run(study, true), released = run(study, false);
    Study other;
    const auto anew = run(other, false);
    for (std::size_t k = 0; k < anew->points.size(); ++k) {
        EXPECT_EQ(released->points[k].value.interreflected.value, anew->points[k].value.interreflected.value);
        EXPECT_GT(dragged->points[k].value.error.mesh, 0.0) << "it is estimated once the scene is let go";
    }
}

/// White, but for the wall at x = 0.
Scene room_with_a_red_wall() {
    Scene scene = test::box_room({4.0, 4.0, 3.0}, 0.7);
    Material red{scene.new_id(), "red", 0.25, {}};
    red.tint = possible_tint({3.0, 0.45, 0.55}, red.reflectance);
    scene.materials.push_back(red);
    scene.room->wall_materials[3] = red.id;
    scene.luminaires.push_back(test::panel(scene, {2.0, 2.0, 2.9}, {1.0, 1.0}, 5000.0));
    return scene;
}

TEST(Display, of_a_room_without_colour_has_no_tints) {
    EXPECT_TRUE(Shown().show(test::small_office())->display->tinted.empty());
}

TEST(Display, tints_have_the_luminance_of_the_whole_light) {
    const auto solution = Shown().show(room_with_a_red_wall());
    const DisplayMesh& display = *solution->display;
    ASSERT_EQ(display.tinted.size(), display.vertices.size());
    for (std::size_t k = 0; k < display.vertices.size(); ++k) {
        const auto& [red, green, blue] = display.tinted[k];
        const double total = display.vertices[k].direct + display.vertices[k].interreflected;
        EXPECT_NEAR(luminance({red, green, blue}), total, rounding * (1.0 + total));
    }
}

TEST(Display, a_red_wall_reddens_the_white_one_beside_it_and_more_the_nearer) {
    for (const Method method : methods) {
        Settings settings = settings_of_tests();
        settings.method = method;
        const auto solution = Study().run(std::make_shared<const Scene>(room_with_a_red_wall()), settings,
                                          StudyRequest{.display = true, .mesh_error = false}, Work{});
        const DisplayMesh& display = *solution->display;
        ASSERT_EQ(display.tinted.size(), display.vertices.size());
        double near = 0.0, far = 0.0;  // red over green on the wall at y = 0
        for (std::size_t k = 0; k < display.vertices.size(); ++k) {
            const Vec3& place = display.vertices[k].position;
            if (place.y > 1e-6 || place.z < 0.8 || place.z > 2.0) continue;
            const double ratio = static_cast<double>(display.tinted[k][0] / display.tinted[k][1]);
            if (place.x > 0.2 && place.x < 0.8) near = std::max(near, ratio);
            if (place.x > 3.2 && place.x < 3.8) far = std::max(far, ratio);
        }
        EXPECT_GT(near, 1.05) << name_of(method);
        EXPECT_GT(near, far + 0.02) << name_of(method);
        EXPECT_GT(far, 1.0) << name_of(method) << ": some red light reaches everything";
    }
}

}  // namespace
}  // namespace hanei
