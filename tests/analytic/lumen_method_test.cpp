/// The number of luminaires foretold by the lumen method against the solution of the same empty rooms.
#include "engine/edit/hanging.h"
#include "engine/edit/start_layout.h"
#include "engine/study/study.h"
#include "tests/unit/edit/luminaire_scenes.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

Scene room_of(const Vec2& size, double height) {
    Scene scene = empty_room();
    scene.room->plan = {{0.0, 0.0}, {size.x, 0.0}, {size.x, size.y}, {0.0, size.y}};
    scene.room->height = height;
    return scene;
}

double computed_mean(const Scene& scene, double patch) {
    Settings settings;
    settings.max_patch = patch;
    const SolutionSnapshot solution =
        Study().run(std::make_shared<const Scene>(scene), settings, {.mesh_error = false}, Work{});
    return figures_of(solution->grids.front()).mean;
}

TEST(LumenMethod, foretells_the_mean_of_empty_rooms_within_a_tenth) {
    struct Case {
        Vec2 size;
        double height;
    };
    // room indices of 0.6, 1.2, 1.7 and a corridor
    for (const Case& room :
         {Case{{2.4, 2.4}, 3.0}, Case{{6.0, 4.0}, 2.8}, Case{{9.0, 7.0}, 3.2}, Case{{16.0, 2.2}, 2.7}}) {
        for (const double exponent : {1.0, 3.0}) {
            const Added lamp = with_measured_luminaire(room_of(room.size, room.height), test::lobe(exponent));
            LumenWish wish;
            wish.mounting.mounting = Mounting::surface;
            const LumenAnswer answer = lumen_method(lamp.scene, lamp.scene.luminaires.front(), wish);
            ASSERT_EQ(answer.refusal, "");
            const Added hung = with_start_layout(lamp.scene, lamp.object, wish, answer);
            const double mean = computed_mean(hung.scene, 0.1 * std::max(room.size.x, room.size.y));
            constexpr double promised = 0.1;
            EXPECT_NEAR(answer.mean / mean, 1.0, promised)
                << room.size.x << " x " << room.size.y << " m, room index " << answer.room_index;
        }
    }
}

}  // namespace
}  // namespace hanei
