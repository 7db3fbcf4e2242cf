#include "engine/geometry/triangle_shells.h"

#include "engine/geometry/flat_faces.h"
#include "engine/geometry/polygon.h"

#include <cmath>
#include <gtest/gtest.h>
#include <utility>

namespace hanei {
namespace {

constexpr double apart = 1e-6;  // m: places nearer to each other are one

void add_quad(TriangleSoup& soup, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const int first = static_cast<int>(soup.vertices.size());
    soup.vertices.insert(soup.vertices.end(), {a, b, c, d});
    soup.triangles.push_back({{first, first + 1, first + 2}, 0});
    soup.triangles.push_back({{first, first + 2, first + 3}, 0});
}

/// Faces outward, corners of its own for each.
void add_box(TriangleSoup& soup, const Vec3& low, const Vec3& high) {
    const auto at = [&](bool x, bool y, bool z) {
        return Vec3{x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z};
    };
    add_quad(soup, at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0));
    add_quad(soup, at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1));
    add_quad(soup, at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1));
    add_quad(soup, at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1));
    add_quad(soup, at(1, 1, 0), at(0, 1, 0), at(0, 1, 1), at(1, 1, 1));
    add_quad(soup, at(0, 1, 0), at(0, 0, 0), at(0, 0, 1), at(0, 1, 1));
}

std::vector<TriangleShell> welded_shells(TriangleSoup soup) {
    weld(soup, apart);
    return shells_of(soup);
}

TEST(TriangleShells, corners_a_hair_apart_make_a_closed_box) {
    TriangleSoup soup;
    add_box(soup, {0, 0, 0}, {1, 2, 3});
    for (std::size_t k = 0; k < soup.vertices.size(); ++k) soup.vertices[k].x += 1e-8 * static_cast<double>(k % 7);
    const auto shells = welded_shells(soup);
    ASSERT_EQ(shells.size(), 1U);
    EXPECT_TRUE(shells[0].closed);
    EXPECT_EQ(shells[0].vertices.size(), 8U);
    EXPECT_NEAR(shells[0].volume, 6.0, apart);  // as far as its corners were moved
}

TEST(TriangleShells, boxes_that_share_a_face_or_an_edge_stay_two) {
    for (const Vec3& beside : {Vec3{1, 0, 0}, Vec3{1, 1, 0}}) {
        TriangleSoup soup;
        add_box(soup, {0, 0, 0}, {1, 1, 1});
        add_box(soup, beside, beside + Vec3{1, 1, 1});
        const auto shells = welded_shells(soup);
        ASSERT_EQ(shells.size(), 2U);
        for (const TriangleShell& shell : shells) {
            EXPECT_TRUE(shell.closed);
            EXPECT_NEAR(shell.volume, 1.0, 1e-12);
        }
    }
}

TEST(TriangleShells, a_box_without_its_top_is_open_and_keeps_its_windings) {
    TriangleSoup soup;
    add_box(soup, {0, 0, 0}, {1, 1, 1});
    soup.triangles.erase(soup.triangles.begin() + 2, soup.triangles.begin() + 4);
    const auto shells = welded_shells(soup);
    ASSERT_EQ(shells.size(), 1U);
    EXPECT_FALSE(shells[0].closed);
    EXPECT_EQ(shells[0].turned, 0U);
}

TEST(TriangleShells, two_sheets_back_to_back_enclose_nothing) {
    TriangleSoup soup;
    add_quad(soup, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    add_quad(soup, {0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0});
    for (const TriangleShell& shell : welded_shells(soup)) EXPECT_FALSE(shell.closed);
}

TEST(TriangleShells, a_strip_of_one_side_is_told) {
    constexpr int steps = 24;
    TriangleSoup soup;
    const auto rung = [&](int k, double side) {
        const double turn = 6.283185307179586 * k / steps;
        const Vec3 middle{std::cos(turn), std::sin(turn), 0.0};
        return middle + 0.3 * side * (std::cos(turn / 2) * middle + std::sin(turn / 2) * Vec3{0, 0, 1});
    };
    for (int k = 0; k < steps; ++k) add_quad(soup, rung(k, -1), rung(k, 1), rung(k + 1, 1), rung(k + 1, -1));
    const auto shells = welded_shells(soup);
    ASSERT_EQ(shells.size(), 1U);
    EXPECT_TRUE(shells[0].one_sided);
    EXPECT_FALSE(shells[0].closed);
}

TEST(TriangleShells, a_shell_winds_once_around_what_is_inside) {
    TriangleSoup soup;
    add_box(soup, {0, 0, 0}, {1, 1, 1});
    const auto shells = welded_shells(soup);
    EXPECT_NEAR(winding_number(shells[0], {0.3, 0.5, 0.9}), 1.0, 1e-12);
    EXPECT_NEAR(winding_number(shells[0], {1.3, 0.5, 0.9}), 0.0, 1e-12);
}

TEST(TriangleShells, a_corner_of_a_neighbour_on_an_edge_cuts_the_triangle) {
    TriangleSoup soup;
    add_quad(soup, {0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0});
    add_quad(soup, {0, 0, 0}, {0, 0, -1}, {1, 0, -1}, {1, 0, 0});
    add_quad(soup, {1, 0, 0}, {1, 0, -1}, {2, 0, -1}, {2, 0, 0});
    EXPECT_EQ(weld(soup, apart).split, 1U);
    EXPECT_EQ(soup.triangles.size(), 7U);
    EXPECT_EQ(shells_of(soup).size(), 1U);
}

double area_of(const std::vector<FlatFace>& faces) {
    double sum = 0.0;
    for (const FlatFace& face : faces) sum += face.area;
    return sum;
}

TEST(FlatFaces, a_sheet_with_a_window_is_one_face_with_a_hole_or_several_without) {
    TriangleSoup soup;
    for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 3; ++y)
            if (x != 1 || y != 1) add_quad(soup, {x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0});
    const auto shells = welded_shells(soup);
    ASSERT_EQ(shells.size(), 1U);
    const auto whole = flat_faces(shells[0], {true, false, apart});
    ASSERT_EQ(whole.size(), 1U);
    EXPECT_EQ(whole[0].loop.size(), 4U);
    ASSERT_EQ(whole[0].holes.size(), 1U);
    EXPECT_EQ(whole[0].holes[0].size(), 4U);
    const auto cut = flat_faces(shells[0], {false, false, apart});
    EXPECT_GE(cut.size(), 2U);
    EXPECT_NEAR(area_of(cut), 8.0, 1e-12);
    for (const FlatFace& face : cut) EXPECT_TRUE(face.holes.empty());
}

TEST(FlatFaces, faces_of_different_labels_stay_apart_when_asked) {
    TriangleSoup soup;
    add_quad(soup, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    soup.triangles[1].label = 7;
    const auto shells = welded_shells(soup);
    EXPECT_EQ(flat_faces(shells[0], {true, true, apart}).size(), 2U);
    EXPECT_EQ(flat_faces(shells[0], {true, false, apart}).size(), 1U);
}

}  // namespace
}  // namespace hanei
