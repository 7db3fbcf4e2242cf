#include "engine/direct/flat_cell.h"

#include "engine/geometry/polygon.h"
#include "tests/unit/geometry/shapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace hanei {
namespace {

using testing::Dice;

Polygon some_polygon(Dice& dice, int corners) {
    const Mat3 turn = dice.rotation();
    const Vec3 middle = dice.place(3);
    const double wide = dice.uniform(0.1, 2), deep = dice.uniform(0.1, 2), start = dice.uniform(0, 6);
    Polygon polygon;
    for (int k = 0; k < corners; ++k) {
        const double angle = start + 2 * std::numbers::pi * k / corners;
        polygon.push_back(middle + turn * Vec3{wide * std::cos(angle), deep * std::sin(angle), 0});
    }
    return polygon;
}

/// The mean of a quadratic over a polygon: over a triangle that of its sides' middles.
double mean_of(const Polygon& polygon, const Vec3& way, const Vec3& other) {
    double sum = 0, area = 0;
    const auto value = [&](const Vec3& place) { return 1 + glm::dot(place, way) * (2 + glm::dot(place, other)); };
    for (std::size_t k = 2; k < polygon.size(); ++k) {
        const Vec3 &a = polygon[0], &b = polygon[k - 1], &c = polygon[k];
        const double part = 0.5 * glm::length(glm::cross(b - a, c - a));
        area += part;
        sum += part / 3 * (value(0.5 * (a + b)) + value(0.5 * (b + c)) + value(0.5 * (c + a)));
    }
    return sum / area;
}

double mean_over_nodes(const FlatCell& cell, const Vec3& way, const Vec3& other) {
    double sum = 0;
    for (const Vec3& place : cell.nodes()) sum += 1 + glm::dot(place, way) * (2 + glm::dot(place, other));
    return sum / static_cast<double>(cell.count);
}

TEST(FlatCell, nodes_stand_for_every_quadratic) {
    Dice dice(1);
    for (int corners = 3; corners < 9; ++corners) {
        for (int k = 0; k < 20; ++k) {
            const Polygon polygon = some_polygon(dice, corners);
            const Vec3 way = dice.direction(), other = dice.direction();
            EXPECT_NEAR(mean_over_nodes(FlatCell(polygon), way, other), mean_of(polygon, way, other), 1e-12);
        }
    }
}

TEST(FlatCell, of_a_rectangle_they_are_its_gauss_points) {
    const FlatCell cell({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}});
    ASSERT_EQ(cell.count, 4U);
    for (const Vec3& node : cell.nodes()) {
        EXPECT_NEAR(std::abs(node.x - 1), 1 / std::sqrt(3.0), 1e-14);
        EXPECT_NEAR(std::abs(node.y - 0.5), 0.5 / std::sqrt(3.0), 1e-14);
    }
}

TEST(FlatCell, halves_together_are_the_whole) {
    Dice dice(2);
    for (int corners = 3; corners < 9; ++corners) {
        const FlatCell whole(some_polygon(dice, corners));
        const std::vector<FlatCell> halves = whole.halves();
        ASSERT_EQ(halves.size(), 2U);
        EXPECT_NEAR(halves[0].size + halves[1].size, whole.size, 1e-12);
        EXPECT_LT(glm::length(halves[0].along), glm::length(whole.along));
    }
}

TEST(FlatCell, lines_and_points_are_cells_too) {
    const FlatCell line(Polygon{{0, 0, 0}, {0, 0, 2}});
    ASSERT_EQ(line.count, 2U);
    EXPECT_NEAR(std::abs(line.places[0].z - 1), 1 / std::sqrt(3.0), 1e-14);
    ASSERT_EQ(line.halves().size(), 2U);
    EXPECT_NEAR(line.halves()[1].centre.z, 1.5, 1e-14);
    EXPECT_EQ(FlatCell(Polygon{{1, 2, 3}}).count, 1U);
    EXPECT_TRUE(FlatCell(Polygon{{1, 2, 3}}).halves().empty());
}

TEST(FlatCell, without_area_there_are_no_nodes) {
    EXPECT_EQ(FlatCell(Polygon{}).count, 0U);
    EXPECT_EQ(FlatCell(Polygon{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}).count, 0U);
}

}  // namespace
}  // namespace hanei
