/// What an edit makes anew: by the stages that a second study reuses, and that nothing kept changes
/// a bit of the answer.
#include "engine/scene/colour.h"
#include "tests/unit/study/runs.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace hanei {
namespace {

using namespace test;

using Edit = std::function<void(Scene&)>;
using Stages = std::vector<Stage>;
const Stages everything{Stage::direct, Stage::factors, Stage::balance, Stage::gathering};
const Stages all_but_values{Stage::direct, Stage::factors, Stage::balance};
/// Where patches are cut finer hangs on the light and on what is asked: on every line of the table.
const StudyRequest unrefined{.refine = false};

const Stages direct_and_factors{Stage::direct, Stage::factors};
const Stages factors_alone{Stage::factors};
const Stages nothing{};

/// Stages of a study after the last of some edits, one by one, by whether they were reused.
class Invalidation : public testing::TestWithParam<Method> {
protected:
    void run(
        const std::vector<Edit>& edits, const std::function<void(Settings&)>& change = [](Settings&) {},
        Scene scene = grouped_office()) {
        Settings settings = coarse_settings(GetParam());
        Study study;
        before_ = study.run(snapshot(scene), settings, unrefined, Work{});
        for (const Edit& edit : edits) {
            edit(scene);
            if (&edit == &edits.back()) change(settings);
            after_ = study.run(snapshot(scene), settings, unrefined, Work{});
        }
        const auto fresh = Study().run(snapshot(scene), settings, unrefined, Work{});
        EXPECT_EQ(values_of(*after_), values_of(*fresh)) << "what was kept changed the answer";
    }
    void run(const Edit& edit) { run(std::vector<Edit>{edit}); }

    Stages kept() const {
        Stages kept;
        for (const Stage stage : everything)
            if (std::any_of(after_->times.begin(), after_->times.end(),
                            [&](const StageTime& time) { return time.stage == stage && time.reused; }))
                kept.push_back(stage);
        return kept;
    }
    bool kept_mesh() const { return before_->mesh == after_->mesh; }

    SolutionSnapshot before_, after_;
};

INSTANTIATE_TEST_SUITE_P(methods, Invalidation, testing::ValuesIn(methods), [](const auto& instance) {
    std::string name(name_of(instance.param));
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST_P(Invalidation, nothing_changed_reuses_every_stage) {
    run([](Scene&) {});
    EXPECT_EQ(kept(), everything);
    EXPECT_TRUE(kept_mesh());
}

TEST_P(Invalidation, a_new_view_reuses_every_stage) {
    run([](Scene& scene) {
        scene.views.push_back({scene.new_id(), "new", {1.0, 1.0, 1.0}, {2.0, 2.0, 1.0}, 0.9, false, {}});
    });
    EXPECT_EQ(kept(), everything);
    EXPECT_TRUE(kept_mesh());
}

TEST_P(Invalidation, another_name_of_an_object_reuses_every_stage) {
    run([](Scene& scene) {
        scene.furniture.front().name = "desk by the door";
        scene.luminaires.front().name = "first row";
        scene.title = "another";
    });
    EXPECT_EQ(kept(), everything);
}

TEST_P(Invalidation, a_moved_calculation_point_leaves_the_balance_alone) {
    run([](Scene& scene) { scene.points.front().position.x += 0.3; });
    EXPECT_EQ(kept(), all_but_values);
}

TEST_P(Invalidation, a_moved_calculation_grid_leaves_the_balance_alone) {
    run([](Scene& scene) { scene.grids.front().corner.y += 0.1; });
    EXPECT_EQ(kept(), all_but_values);
    EXPECT_TRUE(kept_mesh());
}

TEST_P(Invalidation, dimming_a_luminaire_computes_nothing_anew) {
    run([](Scene& scene) { scene.luminaires[0].dimming = 0.4; });
    EXPECT_EQ(kept(), everything);
}

TEST_P(Invalidation, dimming_a_whole_group_computes_nothing_anew) {
    run([](Scene& scene) {
        for (Luminaire& luminaire : scene.luminaires)
            if (luminaire.group) luminaire.dimming = 0.25;
    });
    EXPECT_EQ(kept(), everything);
}

TEST_P(Invalidation, dimming_one_of_a_group_balances_anew) {
    run([](Scene& scene) { scene.luminaires[2].dimming = 0.5; });
    EXPECT_EQ(kept(), direct_and_factors);
}

TEST_P(Invalidation, a_light_scene_of_several_groups_computes_nothing_anew) {
    run([](Scene& scene) {
        scene.luminaires[0].dimming = 0.0;
        scene.luminaires[1].dimming = 0.3;
        scene.luminaires[2].dimming = scene.luminaires[3].dimming = 0.6;
    });
    EXPECT_EQ(kept(), everything);
}

TEST_P(Invalidation, the_dimmer_of_a_group_computes_nothing_anew) {
    run([](Scene& scene) { scene.control_groups.front().dimming = 0.3; });
    EXPECT_EQ(kept(), everything);
}

TEST_P(Invalidation, a_group_switched_off_and_on_by_its_dimmer_computes_nothing_anew) {
    run({[](Scene& scene) { scene.control_groups.front().dimming = 0.0; },
         [](Scene& scene) { scene.control_groups.front().dimming = 0.9; }});
    EXPECT_EQ(kept(), everything);
}

TEST_P(Invalidation, the_dimmer_of_a_group_does_what_the_dimmers_of_all_its_luminaires_do) {
    run([](Scene& scene) { scene.control_groups.front().dimming = 0.25; });
    const std::vector<double> by_group = values_of(*after_);
    run([](Scene& scene) {
        for (Luminaire& luminaire : scene.luminaires)
            if (luminaire.group) luminaire.dimming = 0.25;
    });
    EXPECT_EQ(values_of(*after_), by_group);
}

TEST_P(Invalidation, recalling_a_light_scene_computes_nothing_anew) {
    Scene scene = grouped_office();
    const ObjectId second = scene.new_id();
    scene.control_groups.push_back({second, "rest", 1.0, 0.0, {}});
    for (Luminaire& luminaire : scene.luminaires)
        if (!luminaire.group) luminaire.group = second;
    run(
        {[](Scene& lit) {
            lit.control_groups[0].dimming = 0.2;
            lit.control_groups[1].dimming = 0.8;
        }},
        [](Settings&) {}, scene);
    EXPECT_EQ(kept(), everything);
}

TEST_P(Invalidation, the_colour_temperature_of_a_group_is_mixed_once_light_has_colours) {
    Scene coloured = grouped_office();
    coloured.luminaires[0].colour_temperature = 2700.0;
    coloured.control_groups.front().colour_temperature = 4000.0;
    run(
        {[](Scene& scene) { scene.control_groups.front().colour_temperature = 6500.0; }}, [](Settings&) {}, coloured);
    EXPECT_EQ(kept(), everything);
}

TEST_P(Invalidation, the_first_colour_temperature_of_a_group_redoes_the_balance_only) {
    run([](Scene& scene) { scene.control_groups.front().colour_temperature = 2700.0; });
    EXPECT_EQ(kept(), direct_and_factors);
    EXPECT_TRUE(kept_mesh());
}

TEST_P(Invalidation, a_luminaire_switched_off_and_on_again_computes_nothing_anew) {
    run({[](Scene& scene) { scene.luminaires[1].dimming = 0.0; },
         [](Scene& scene) { scene.luminaires[1].dimming = 0.7; }});
    EXPECT_EQ(kept(), everything);
}

TEST_P(Invalidation, a_luminaire_first_switched_on_leaves_form_factors_alone) {
    Scene dark = grouped_office();
    dark.luminaires[1].dimming = 0.0;
    run(
        {[](Scene& scene) { scene.luminaires[1].dimming = 1.0; }}, [](Settings&) {}, dark);
    EXPECT_EQ(kept(), factors_alone);
}

TEST_P(Invalidation, many_luminaires_of_one_level_are_dimmed_without_computing) {
    Scene many = grouped_office();
    for (int k = 0; k < 8; ++k)
        many.luminaires.push_back(test::panel(many, {0.6 + 0.6 * k, 3.2, 2.7}, {0.3, 0.3}, 300.0));
    run(
        {[](Scene& scene) {
            for (Luminaire& luminaire : scene.luminaires) luminaire.dimming = 0.5;
        }},
        [](Settings&) {}, many);
    EXPECT_EQ(kept(), everything);
}

TEST_P(Invalidation, the_maintenance_factor_computes_nothing_anew) {
    run([](Scene& scene) { scene.maintenance_factor = 0.8; });
    EXPECT_EQ(kept(), everything);
}

TEST_P(Invalidation, a_change_of_reflectance_redoes_the_balance_only) {
    run([](Scene& scene) { scene.materials.front().reflectance = 0.7; });
    EXPECT_EQ(kept(), direct_and_factors);
    EXPECT_TRUE(kept_mesh());
}

TEST_P(Invalidation, a_colour_on_a_neutral_surface_redoes_the_balance_only) {
    run([](Scene& scene) { scene.materials.front().tint = possible_tint({1.4, 0.9, 0.8}, 0.5); });
    EXPECT_EQ(kept(), direct_and_factors);
    EXPECT_TRUE(kept_mesh());
}

TEST_P(Invalidation, another_colour_redoes_the_balance_only) {
    run({[](Scene& scene) {
             scene.materials.front().tint = possible_tint({1.4, 0.9, 0.8}, 0.5);
         },
         [](Scene& scene) {
             scene.materials.front().tint = possible_tint({0.6, 1.1, 1.2}, 0.5);
         }});
    EXPECT_EQ(kept(), direct_and_factors);
}

TEST_P(Invalidation, a_colour_taken_off_again_gives_the_neutral_answer) {
    run({[](Scene& scene) {
             scene.materials.front().tint = possible_tint({1.4, 0.9, 0.8}, 0.5);
         },
         [](Scene& scene) { scene.materials.front().tint = Vec3{1.0}; }});
    EXPECT_EQ(values_of(*after_), values_of(*before_));
}

TEST_P(Invalidation, another_material_on_a_wall_redoes_the_balance_only) {
    Scene painted = grouped_office();
    painted.materials.push_back({painted.new_id(), "dark", 0.1, {}});
    run(
        {[](Scene& scene) { scene.room->wall_materials.front() = scene.materials.back().id; }}, [](Settings&) {},
        painted);
    EXPECT_EQ(kept(), direct_and_factors);
}

TEST_P(Invalidation, another_colour_temperature_of_a_lamp_redoes_the_balance_only) {
    run([](Scene& scene) { scene.luminaires[1].colour_temperature = 2700.0; });
    EXPECT_EQ(kept(), direct_and_factors);
    EXPECT_TRUE(kept_mesh());
}

TEST_P(Invalidation, a_moved_luminaire_leaves_form_factors_alone) {
    run([](Scene& scene) { scene.luminaires[0].position.x += 0.5; });
    EXPECT_EQ(kept(), factors_alone);
    EXPECT_TRUE(kept_mesh());
}

TEST_P(Invalidation, a_turned_luminaire_leaves_form_factors_alone) {
    run([](Scene& scene) {
        scene.luminaires[0].position.z -= 0.4;
        scene.luminaires[0].yaw = 0.5;
        scene.luminaires[0].tilt = 0.3;
    });
    EXPECT_EQ(kept(), factors_alone);
    EXPECT_TRUE(kept_mesh());
}

TEST_P(Invalidation, other_photometry_leaves_form_factors_alone) {
    run([](Scene& scene) {
        scene.photometries.push_back(test::beam(scene, 8.0));
        scene.luminaires[3].distribution = Measured{scene.photometries.back().id};
    });
    EXPECT_EQ(kept(), factors_alone);
    EXPECT_TRUE(kept_mesh());
}

TEST_P(Invalidation, other_figures_in_a_luminaire_file_leave_form_factors_alone) {
    run([](Scene& scene) {
        for (double& candela : scene.photometries.front().candela) candela *= 1.5;
    });
    EXPECT_EQ(kept(), factors_alone);
}

TEST_P(Invalidation, a_luminaire_taken_away_and_one_hung_up_leave_form_factors_alone) {
    run({[](Scene& scene) { scene.luminaires.erase(scene.luminaires.begin()); },
         [](Scene& scene) {
             scene.luminaires.push_back(test::panel(scene, {3.0, 2.5, 2.5}, {0.6, 0.6}, 2000.0));
         }});
    EXPECT_EQ(kept(), factors_alone);
    EXPECT_TRUE(kept_mesh());
}

TEST_P(Invalidation, moved_furniture_redoes_form_factors_and_direct_light) {
    run([](Scene& scene) { scene.furniture.front().position.x += 0.5; });
    EXPECT_EQ(kept(), nothing);
}

TEST_P(Invalidation, furniture_moved_back_gives_the_first_answer) {
    run({[](Scene& scene) { scene.furniture.front().position.x += 0.5; },
         [](Scene& scene) { scene.furniture.front().rotation = 0.4; },
         [](Scene& scene) { scene.furniture.front() = grouped_office().furniture.front(); }});
    EXPECT_EQ(values_of(*after_), values_of(*before_));
}

TEST_P(Invalidation, another_room_shape_redoes_everything) {
    run([](Scene& scene) { scene.room->height = 3.1; });
    EXPECT_EQ(kept(), nothing);
}

TEST_P(Invalidation, another_patch_width_redoes_everything) {
    run({[](Scene&) {}}, [](Settings& settings) { settings.max_patch = 0.6; });
    EXPECT_EQ(kept(), nothing);
    EXPECT_FALSE(kept_mesh());
}

TEST_P(Invalidation, another_method_redoes_form_factors_and_balance) {
    for (const Method other : methods) {
        if (other == GetParam()) continue;
        run({[](Scene&) {}}, [&](Settings& settings) { settings = coarse_settings(other); });
        for (const Stage stage : kept()) EXPECT_TRUE(stage == Stage::direct || stage == Stage::gathering);
    }
}

TEST_P(Invalidation, other_threads_reuse_every_stage) {
    run({[](Scene&) {}}, [](Settings& settings) { settings.threads = 3; });
    EXPECT_EQ(kept(), everything);
}

TEST_P(Invalidation, a_moved_opaque_luminaire_shadows_where_it_hangs_now) {
    Scene hanging = grouped_office();
    for (Luminaire& luminaire : hanging.luminaires) {
        luminaire.opaque = true;
        luminaire.position.z = 2.5;
    }
    std::vector<Edit> moves;
    for (const double x : {1.2, 2.6, 4.0}) {
        moves.push_back([x](Scene& scene) { scene.luminaires.front().position.x = x; });
        run(
            moves, [](Settings&) {}, hanging);
    }
}

TEST_P(Invalidation, a_moved_opaque_luminaire_uncovers_the_ceiling_it_lay_on) {
    Scene scene = grouped_office();
    scene.luminaires.front().opaque = true;
    scene.luminaires.front().position.z = 2.8;
    scene.points.push_back(test::point(scene, {1.8, 2.0, 2.8}, {0.0, 0.0, -1.0}));
    run(
        {[](Scene& moved) { moved.luminaires.front().position.x = 4.8; }}, [](Settings&) {}, scene);
    EXPECT_GT(after_->points.back().value.total().value, 1.0);
}

}  // namespace
}  // namespace hanei
