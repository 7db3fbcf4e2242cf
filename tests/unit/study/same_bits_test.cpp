/// The same answer to the bit on any number of threads, wherever rows are kept.
#include "engine/scene/colour.h"
#include "tests/unit/study/runs.h"

#include <gtest/gtest.h>
#include <tuple>

namespace hanei {
namespace {

constexpr int plenty = 1024;  // MB: rows as floats
constexpr int little = 1;     // MB: compact rows, on disk for the most part

/// The office with a dark red wall and one warm lamp.
Scene coloured_office() {
    Scene scene = test::grouped_office();
    scene.materials.push_back({scene.new_id(), "red", 0.3, {}, possible_tint({2.0, 0.7, 0.6}, 0.3)});
    scene.room->wall_materials[1] = scene.materials.back().id;
    scene.luminaires[1].colour_temperature = 3000.0;
    return scene;
}

class SameBits : public testing::TestWithParam<std::tuple<Method, bool, int>> {
protected:
    std::vector<double> run(Study& study, const Scene& scene, int threads) const {
        const auto [method, coloured, memory] = GetParam();
        Settings settings = test::coarse_settings(method);
        settings.max_patch = (method == Method::linear ? 1.5 : 1.0) * (memory == plenty ? 0.6 : 0.4);
        settings.memory_mb = memory;
        settings.threads = threads;
        const StudyRequest request{.display = true};
        return test::values_of(*study.run(test::snapshot(scene), settings, request, Work{}));
    }
    static Scene office() { return std::get<1>(GetParam()) ? coloured_office() : test::grouped_office(); }
};

std::string name_of_run(const testing::TestParamInfo<SameBits::ParamType>& run) {
    const auto [method, coloured, memory] = run.param;
    const std::string bare = method == Method::paper_closed ? "paper_closed" : std::string(name_of(method));
    return bare + (coloured ? "_coloured" : "_neutral") + (memory == plenty ? "_in_memory" : "_in_little_memory");
}

INSTANTIATE_TEST_SUITE_P(rooms, SameBits,
                         testing::Combine(testing::ValuesIn(methods), testing::Bool(), testing::Values(plenty, little)),
                         name_of_run);

TEST_P(SameBits, on_one_thread_on_two_and_on_seven) {
    Study one, two, seven;
    Scene scene = office();
    const auto expected = run(one, scene, 1);
    EXPECT_EQ(run(two, scene, 2), expected);
    EXPECT_EQ(run(seven, scene, 7), expected);
    scene.furniture.front().position += Vec3{0.4, 0.1, 0.0};  // shares rewritten in place
    scene.luminaires.back().dimming = 0.5;
    const auto moved = run(one, scene, 1);
    EXPECT_NE(moved, expected);
    EXPECT_EQ(run(two, scene, 2), moved);
    EXPECT_EQ(run(seven, scene, 7), moved);
}

TEST(Rows, that_are_read_from_disk_give_the_bits_of_rows_in_memory) {
    for (const Method method : methods) {
        std::vector<std::vector<double>> values;
        for (const int memory : {little, 30}) {  // MB: too little for floats both times, the second enough to keep all
            Settings settings = test::coarse_settings(method);
            settings.max_patch = method == Method::linear ? 0.5 : 0.25;
            settings.memory_mb = memory;
            const auto solution = Study().run(test::snapshot(test::grouped_office()), settings,
                                              StudyRequest{.mesh_error = false, .refine = false}, Work{});
            values.push_back(test::values_of(*solution));
        }
        EXPECT_EQ(values[0], values[1]) << name_of(method);
    }
}

TEST(Rows, that_are_kept_compactly_change_values_by_less_than_their_error_bars) {
    for (const Method method : {Method::patch, Method::linear}) {
        Settings settings = test::coarse_settings(method);
        settings.max_patch = method == Method::linear ? 0.5 : 0.25;
        const auto exact = Study().run(test::snapshot(test::grouped_office()), settings, StudyRequest{}, Work{});
        settings.memory_mb = little;
        const auto compact = Study().run(test::snapshot(test::grouped_office()), settings, StudyRequest{}, Work{});
        EXPECT_NE(test::values_of(*exact), test::values_of(*compact)) << "both were kept as floats";
        for (std::size_t k = 0; k < exact->points.size(); ++k) {
            const PointValue& value = compact->points[k].value;
            EXPECT_NEAR(value.total().value, exact->points[k].value.total().value, value.error.total())
                << name_of(method);
        }
    }
}

}  // namespace
}  // namespace hanei
