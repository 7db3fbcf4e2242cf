#include "engine/direct/opening_integral.h"

#include "engine/geometry/polygon.h"
#include "tests/unit/direct/scenes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace hanei {
namespace {

constexpr double finest_beam = 0.3;

/// Flat, facing down, about the origin.
Polygon ellipse(double half_x, double half_y) {
    constexpr int corners = 32;
    const double out = std::sqrt(2.0 * std::numbers::pi / corners / std::sin(2.0 * std::numbers::pi / corners));
    Polygon outline;
    for (int k = 0; k < corners; ++k) {
        const double angle = -2.0 * std::numbers::pi * k / corners;
        outline.push_back({half_x * out * std::cos(angle), half_y * out * std::sin(angle), 0.0});
    }
    return outline;
}
Polygon rectangle(double half_x, double half_y) {
    return {{-half_x, -half_y, 0.0}, {-half_x, half_y, 0.0}, {half_x, half_y, 0.0}, {half_x, -half_y, 0.0}};
}

class AnOpening : public ::testing::Test {
protected:
    std::size_t elements(const Polygon& polygon, const Receiver& receiver) const {
        OpeningIntegral integral(table_, nullptr, receiver, finest_beam);
        integral.add(polygon);
        return integral.elements();
    }
    Estimate light(const std::vector<Polygon>& parts, const Receiver& receiver) const {
        OpeningIntegral integral(table_, nullptr, receiver, finest_beam);
        for (const Polygon& part : parts) integral.add(part);
        return integral.value();
    }
    IntensityTable table_{testing::table([](double gamma) { return 200.0 + 100.0 * std::cos(3.0 * gamma); }, 15)};
};

/// As triangles about one corner they would be 30 needles, each cut by its length.
TEST_F(AnOpening, that_is_round_needs_hardly_more_elements_than_a_square) {
    const double square = 0.5 * std::sqrt(std::numbers::pi);
    for (const double distance : {0.003, 0.02, 0.1, 0.4, 1.0, 3.0}) {
        const Receiver below{{0.1, 0.05, -distance}, {0.0, 0.0, 1.0}, Vec3{0.0}};
        EXPECT_LE(elements(ellipse(0.5, 0.5), below), 2 * elements(rectangle(square, square), below) + 8) << distance;
    }
}

TEST_F(AnOpening, that_is_narrow_is_cut_along_its_length_alone) {
    for (const double distance : {0.1, 0.3, 1.0}) {
        const Receiver below{{0.1, 0.0, -distance}, {0.0, 0.0, 1.0}, Vec3{0.0}};
        EXPECT_LE(elements(rectangle(0.6, 0.005), below), 8.0 + 2.0 * 1.2 / (finest_beam * distance)) << distance;
    }
}

TEST_F(AnOpening, gives_what_its_parts_give) {
    for (const double distance : {0.05, 0.3, 2.0}) {
        const Receiver below{{0.2, -0.1, -distance}, glm::normalize(Vec3{0.2, 0.1, 1.0}), Vec3{0.0}};
        for (const Polygon& whole : {ellipse(0.3, 0.2), rectangle(0.4, 0.1), ellipse(0.5, 0.01)}) {
            std::vector<Polygon> parts;
            for (const double side : {-1.0, 1.0}) {
                const Vec3 across = side * glm::normalize(Vec3{1.0, 0.7, 0.0});
                parts.push_back(clipped(whole, {{0.03, 0.0, 0.0}, across}, 0.0));
            }
            const Estimate one = light({whole}, below), two = light(parts, below);
            EXPECT_NEAR(one.value, two.value, one.error + two.error) << distance;
            EXPECT_LT(one.error, 0.01 * one.value);
        }
    }
}

TEST_F(AnOpening, without_area_gives_nothing) {
    const Receiver below{{0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}, Vec3{0.0}};
    const Polygon line{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.5, 0.0, 0.0}};
    const Polygon place{{0.1, 0.1, 0.0}, {0.1, 0.1, 0.0}, {0.1, 0.1, 0.0}};
    EXPECT_EQ(light({line, place, {}}, below).value, 0.0);
}

}  // namespace
}  // namespace hanei
