/// That the light at a place is divided without rest, whatever the method and the lamps.
#include "engine/study/contributions.h"

#include "engine/scene/colour.h"
#include "tests/unit/study/runs.h"

#include <gtest/gtest.h>
#include <numeric>

namespace hanei {
namespace {

using namespace test;

constexpr double rounding = 1e-9;  // of sums of some thousand products

template <class Rows, class Figure>
double sum_of(const Rows& rows, const Figure& figure) {
    double sum = 0.0;
    for (const auto& row : rows) sum += figure(row);
    return sum;
}

void expect_divided(const Contributions& made) {
    const double direct = made.value.direct.value, reflected = made.value.interreflected.value;
    const double whole = direct + reflected;
    EXPECT_NEAR(sum_of(made.luminaires, [](const auto& row) { return row.direct; }), direct, rounding * whole);
    EXPECT_NEAR(sum_of(made.groups, [](const auto& row) { return row.total(); }), whole, rounding * whole);
    EXPECT_NEAR(sum_of(made.surfaces, [](const auto& row) { return row.lux; }), reflected, rounding * whole);
    const double bounces = sum_of(made.bounces, [](const auto& row) { return row.lux; }) + made.later_bounces;
    EXPECT_NEAR(bounces, reflected, rounding * whole);
    EXPECT_GE(made.later_bounces, -made.value.error.iteration - rounding * whole);
    for (std::size_t k = 1; k < made.surfaces.size(); ++k) EXPECT_LE(made.surfaces[k].lux, made.surfaces[k - 1].lux);
    for (std::size_t k = 1; k < made.luminaires.size(); ++k)
        EXPECT_LE(made.luminaires[k].direct, made.luminaires[k - 1].direct);
}

/// At every calculation point of the scene, against what was reported there.
void expect_reported_values_divided(const Scene& scene, const Settings& settings) {
    Study study;
    const SolutionSnapshot solution = study.run(snapshot(scene), settings, {}, Work{});
    ASSERT_FALSE(solution->grids.empty() && solution->points.empty());
    const auto look_at = [&](const PointResult& point) {
        if (point.value.inside_solid) return;
        const auto made = study.contributions(solution, point.position, point.normal, Work{});
        ASSERT_TRUE(made);
        expect_divided(*made);
        const double reported = point.value.total().value;
        EXPECT_NEAR(made->value.direct.value, point.value.direct.value, point.value.error.sampling + 1e-7 * reported);
        EXPECT_NEAR(made->value.interreflected.value, point.value.interreflected.value,
                    point.value.error.iteration + 1e-6 * reported);  // floats of the rows
    };
    for (const PointResult& point : solution->points) look_at(point);
    for (const GridResult& grid : solution->grids)
        for (std::size_t k = 0; k < grid.points.size(); k += 5) look_at(grid.points[k]);
}

class Divided : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(methods, Divided, testing::ValuesIn(methods), [](const auto& instance) {
    std::string name(name_of(instance.param));
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST_P(Divided, every_reported_value_is_the_sum_of_its_contributions) {
    expect_reported_values_divided(grouped_office(), coarse_settings(GetParam()));
}

TEST_P(Divided, coloured_light_is_divided_without_rest) {
    Scene scene = grouped_office();
    scene.luminaires.front().colour_temperature = 2700.0;
    const Vec3 warm{1.3, 0.95, 0.6};
    scene.materials.front().tint = warm / luminance(warm);
    expect_reported_values_divided(scene, coarse_settings(GetParam()));
}

TEST(Contributions, of_surfaces_that_shine_by_themselves_come_without_a_reflection) {
    Scene scene = grouped_office();
    FreeSurface sky;
    sky.id = scene.new_id();
    sky.name = "sky";
    sky.region.outline = {{0.5, 0.05, 1.0}, {0.5, 0.05, 2.0}, {1.5, 0.05, 2.0}, {1.5, 0.05, 1.0}};
    sky.material = scene.materials.front().id;
    sky.own_exitance = {900.0};
    scene.surfaces.push_back(sky);
    Study study;
    const SolutionSnapshot solution = study.run(snapshot(scene), coarse_settings(), {}, Work{});
    const auto made = study.contributions(solution, {1.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, Work{});
    ASSERT_TRUE(made);
    expect_divided(*made);
    ASSERT_FALSE(made->bounces.empty());
    EXPECT_EQ(made->bounces.front().reflections, 0);
    EXPECT_GT(made->bounces.front().lux, 0.0);
    EXPECT_TRUE(std::any_of(made->groups.begin(), made->groups.end(),
                            [](const auto& group) { return group.luminaires.empty() && group.total() > 0.0; }));
}

TEST(Contributions, of_a_black_room_are_direct_alone) {
    Scene scene = grouped_office();
    for (Material& material : scene.materials) material.reflectance = 0.0;
    Study study;
    const SolutionSnapshot solution = study.run(snapshot(scene), coarse_settings(), {}, Work{});
    const auto made = study.contributions(solution, {1.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, Work{});
    ASSERT_TRUE(made);
    EXPECT_EQ(made->value.interreflected.value, 0.0);
    EXPECT_TRUE(made->surfaces.empty());
    EXPECT_GT(made->value.direct.value, 0.0);
    expect_divided(*made);
}

TEST(Contributions, are_nothing_inside_of_furniture) {
    Study study;
    const Scene scene = grouped_office();
    const SolutionSnapshot solution = study.run(snapshot(scene), coarse_settings(), {}, Work{});
    const Furniture& desk = scene.furniture.front();
    const Vec3 inside = desk.position + desk.parts.front().position + Vec3(0.0, 0.0, 0.01);
    const auto made = study.contributions(solution, inside, {0.0, 0.0, 1.0}, Work{});
    ASSERT_TRUE(made);
    EXPECT_TRUE(made->value.inside_solid);
    EXPECT_TRUE(made->luminaires.empty() && made->surfaces.empty() && made->bounces.empty());
}

TEST(Contributions, of_an_older_solution_are_those_of_its_own_scene) {
    Study study;
    Scene scene = grouped_office();
    const SolutionSnapshot before = study.run(snapshot(scene), coarse_settings(), {}, Work{});
    const Vec3 place{1.0, 1.0, 0.0}, up{0.0, 0.0, 1.0};
    const auto first = study.contributions(before, place, up, Work{});
    scene.luminaires.front().dimming = 0.3;
    const SolutionSnapshot after = study.run(snapshot(scene), coarse_settings(), {}, Work{});
    const auto dimmed = study.contributions(after, place, up, Work{});
    const auto again = study.contributions(before, place, up, Work{});
    ASSERT_TRUE(first && dimmed && again);
    EXPECT_LT(dimmed->value.total().value, first->value.total().value);
    EXPECT_EQ(again->value.total().value, first->value.total().value);
}

TEST(Contributions, stop_when_they_are_asked_to) {
    Study study;
    const SolutionSnapshot solution = study.run(snapshot(grouped_office()), coarse_settings(), {}, Work{});
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(study.contributions(solution, {1.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, Work{1, stop.get_token(), nullptr}));
}

}  // namespace
}  // namespace hanei
