#include "engine/geometry/convex_cells.h"

#include "engine/geometry/configuration_factor.h"
#include "engine/geometry/occluders.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/visible_part.h"
#include "tests/unit/geometry/shapes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

namespace hanei {
namespace {

using testing::Dice;
using testing::facing_down;

struct ClosedSolid {
    std::vector<Vec3> vertices;
    std::vector<std::vector<int>> faces;
};

/// A plan extruded from z = 0 to `height`; the plan runs counter-clockwise seen from above.
ClosedSolid prism(const std::vector<Vec2>& plan, double height) {
    ClosedSolid solid;
    const int n = static_cast<int>(plan.size());
    for (const Vec2& corner : plan) solid.vertices.emplace_back(corner, 0.0);
    for (const Vec2& corner : plan) solid.vertices.emplace_back(corner, height);
    std::vector<int> bottom(plan.size()), top(plan.size());
    std::iota(bottom.rbegin(), bottom.rend(), 0);
    std::iota(top.begin(), top.end(), n);
    solid.faces = {bottom, top};
    for (int k = 0; k < n; ++k) solid.faces.push_back({k, (k + 1) % n, n + (k + 1) % n, n + k});
    return solid;
}

ClosedSolid l_shape() { return prism({{0, 0}, {1.2, 0}, {1.2, 0.5}, {0.5, 0.5}, {0.5, 1}, {0, 1}}, 0.4); }
ClosedSolid c_profile() {
    return prism({{0, 0}, {1, 0}, {1, 0.1}, {0.1, 0.1}, {0.1, 0.9}, {1, 0.9}, {1, 1}, {0, 1}}, 1.5);
}

/// Squares of half width `outer` and `inner`, one in the other: their corners at each of `heights`.
ClosedSolid ring_of_vertices(std::initializer_list<Vec3> outer_inner_height) {
    ClosedSolid solid;
    for (const Vec3& level : outer_inner_height) {
        for (const double half : {level.x, level.y}) {
            for (const Vec2& way : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}}) {
                solid.vertices.emplace_back(half * way, level.z);
            }
        }
    }
    return solid;
}

/// A frame: a square slab with a square hole. Faces with a hole are cut in four.
ClosedSolid frame() {
    ClosedSolid solid = ring_of_vertices({{0.7, 0.4, 0.0}, {0.7, 0.4, 0.3}});
    for (int k = 0; k < 4; ++k) {
        const int next = (k + 1) % 4;
        solid.faces.push_back({k, 4 + k, 4 + next, next});            // below
        solid.faces.push_back({8 + k, 8 + next, 12 + next, 12 + k});  // above
        solid.faces.push_back({k, next, 8 + next, 8 + k});            // outside
        solid.faces.push_back({4 + next, 4 + k, 12 + k, 12 + next});  // in the hole
    }
    return solid;
}

/// A bowl with sloping sides, open above.
ClosedSolid bowl() {
    ClosedSolid solid = ring_of_vertices({{0.4, 0.3, 0.0}, {0.7, 0.65, 0.5}});
    for (int k = 4; k < 8; ++k) solid.vertices[static_cast<std::size_t>(k)].z = 0.05;
    solid.faces = {{3, 2, 1, 0}, {4, 5, 6, 7}};
    for (int k = 0; k < 4; ++k) {
        const int next = (k + 1) % 4;
        solid.faces.push_back({8 + k, 8 + next, 12 + next, 12 + k});  // the rim
        solid.faces.push_back({k, next, 8 + next, 8 + k});
        solid.faces.push_back({4 + next, 4 + k, 12 + k, 12 + next});
    }
    return solid;
}

Polygon loop_of(const ClosedSolid& solid, const std::vector<int>& face) {
    Polygon loop;
    for (const int vertex : face) loop.push_back(solid.vertices[static_cast<std::size_t>(vertex)]);
    return loop;
}

/// Triangles of all faces: the solid as rays meet it, without any of the cells.
std::vector<Polygon> triangles_of(const ClosedSolid& solid) {
    std::vector<Polygon> triangles;
    for (const std::vector<int>& face : solid.faces) {
        for (const Polygon& piece : convex_pieces({loop_of(solid, face), {}})) {
            for (std::size_t k = 2; k < piece.size(); ++k) triangles.push_back({piece[0], piece[k - 1], piece[k]});
        }
    }
    return triangles;
}

/// Where the line from + t along crosses the triangle (Moeller and Trumbore 1997); -1 when it does not.
double crossing(const Polygon& triangle, const Vec3& from, const Vec3& along) {
    const Vec3 a = triangle[1] - triangle[0], b = triangle[2] - triangle[0];
    const Vec3 p = glm::cross(along, b), offset = from - triangle[0];
    const double scale = glm::dot(a, p);
    if (std::abs(scale) < 1e-14) return -1.0;
    const double u = glm::dot(offset, p) / scale;
    const Vec3 q = glm::cross(offset, a);
    const double v = glm::dot(along, q) / scale;
    return u >= 0.0 && v >= 0.0 && u + v <= 1.0 ? glm::dot(b, q) / scale : -1.0;
}

bool is_inside(const std::vector<Polygon>& triangles, const Vec3& place) {
    const Vec3 away{0.31, 0.57, 11.0};
    const auto crosses = [&](const Polygon& triangle) { return crossing(triangle, place, away) > 0.0; };
    return std::ranges::count_if(triangles, crosses) % 2 == 1;
}

/// Blocked when the line crosses the surface on its way or begins into the solid.
bool is_blocked(const std::vector<Polygon>& triangles, const Vec3& from, const Vec3& to) {
    const auto crosses = [&](const Polygon& triangle) {
        const double t = crossing(triangle, from, to - from);
        return t > 1e-9 && t < 1.0 - 1e-9;
    };
    return std::ranges::any_of(triangles, crosses) || is_inside(triangles, from + 1e-7 * (to - from));
}

OccluderSet set_of(const std::vector<ConvexCell>& cells) {
    std::vector<ConvexBody> bodies;
    for (const ConvexCell& cell : cells) bodies.push_back({cell.vertices, cell.faces, 1});
    return OccluderSet(std::move(bodies));
}

double volume_of(const std::vector<Vec3>& vertices, const std::vector<std::vector<int>>& faces) {
    double volume = 0.0;
    for (const std::vector<int>& face : faces) {
        const Polygon loop = loop_of({vertices, {}}, face);
        volume += glm::dot(loop[0], vector_area(loop)) / 3.0;
    }
    return volume;
}

bool in_piece(const Polygon& piece, const Vec3& normal, const Vec3& place, double margin) {
    for (std::size_t k = 0; k < piece.size(); ++k) {
        const Vec3 run = piece[(k + 1) % piece.size()] - piece[k];
        if (glm::dot(glm::cross(normal, run), place - piece[k]) < -margin * glm::length(run)) return false;
    }
    return true;
}

struct Agreement {
    int disagreements = 0;
    int penumbra = 0, umbra = 0, lit = 0;
};

/// Holds the visible part of an opening against sight lines to many places of it.
void compare(const std::vector<Polygon>& triangles, const OccluderSet& set, const Polygon& opening, const Vec3& eye,
             Dice& dice, Agreement& sum) {
    std::vector<BodyIndex> found;
    set.between(eye, opening, found);
    const std::vector<Polygon> pieces = visible_part(opening, eye, set, found);
    const Vec3 normal = unit_normal(opening);
    double area = 0.0;
    for (const Polygon& piece : pieces) area += glm::length(vector_area(piece));
    int open_count = 0;
    constexpr int places = 150;
    for (int k = 0; k < places; ++k) {
        const Vec3 place = opening[0] + dice.uniform(0, 1) * (opening[1] - opening[0]) +
                           dice.uniform(0, 1) * (opening[3] - opening[0]);
        const bool open = !is_blocked(triangles, eye, place);
        const auto holds = [&](double margin) {
            return std::ranges::any_of(pieces, [&](const Polygon& p) { return in_piece(p, normal, place, margin); });
        };
        if (open ? !holds(1e-6) : holds(-1e-6)) ++sum.disagreements;  // a micrometre from a border either is right
        open_count += open;
    }
    const double share = area / glm::length(vector_area(opening));
    // Five standard deviations of a share counted at that many places.
    EXPECT_NEAR(share, open_count / static_cast<double>(places), 5.0 * std::sqrt(0.25 / places));
    sum.umbra += pieces.empty();
    sum.lit += share > 1.0 - 1e-12;
    sum.penumbra += share > 0.0 && share < 1.0 - 1e-12;
}

TEST(ConvexCells, fill_the_solid_and_know_its_faces) {
    EXPECT_EQ(convex_cells(l_shape().vertices, l_shape().faces).size(), 2U);
    EXPECT_EQ(convex_cells(c_profile().vertices, c_profile().faces).size(), 3U);
    for (const ClosedSolid& solid : {l_shape(), c_profile(), frame(), bowl()}) {
        const std::vector<ConvexCell> cells = convex_cells(solid.vertices, solid.faces);
        double volume = 0.0;
        std::vector<int> surface;
        for (const ConvexCell& cell : cells) {
            volume += volume_of(cell.vertices, cell.faces);
            surface.insert(surface.end(), cell.surface.begin(), cell.surface.end());
        }
        EXPECT_NEAR(volume, volume_of(solid.vertices, solid.faces), 1e-12);
        EXPECT_LE(cells.size(), 12U);
        for (int face = 0; face < static_cast<int>(solid.faces.size()); ++face) {
            EXPECT_TRUE(std::ranges::find(surface, face) != surface.end()) << face;
        }
    }
}

TEST(ConvexCells, a_convex_solid_stays_itself_and_what_is_no_solid_gives_none) {
    const ClosedSolid box = prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1);
    const std::vector<ConvexCell> cells = convex_cells(box.vertices, box.faces);
    ASSERT_EQ(cells.size(), 1U);
    EXPECT_EQ(cells[0].vertices, box.vertices);
    EXPECT_EQ(cells[0].surface.size(), 6U);
    EXPECT_TRUE(convex_cells({}, {}).empty());
    EXPECT_TRUE(convex_cells(box.vertices, {{0, 1, 99}}).empty());
    ClosedSolid open = l_shape();
    open.faces.pop_back();
    for (const ConvexCell& cell : convex_cells(open.vertices, open.faces)) EXPECT_GE(cell.faces.size(), 4U);
}

TEST(ConvexCells, light_past_solids_of_any_shape_is_that_of_their_faces) {
    Dice dice(51);
    for (const ClosedSolid& upright : {l_shape(), c_profile(), frame(), bowl()}) {
        Agreement sum;
        for (const bool turned : {false, true}) {
            ClosedSolid solid = upright;
            const Mat3 turn = turned ? dice.rotation() : Mat3{1.0};
            for (Vec3& vertex : solid.vertices) vertex = turn * vertex;
            const std::vector<Polygon> triangles = triangles_of(solid);
            const OccluderSet set = set_of(convex_cells(solid.vertices, solid.faces));
            const Polygon opening = facing_down(-0.4, -0.2, 0.8, 0.7, 1.8);
            for (int k = 0; k < 150; ++k) {
                const Vec3 eye{dice.uniform(-1.5, 2), dice.uniform(-1.5, 2), dice.uniform(-1.5, 1)};
                if (!is_inside(triangles, eye)) compare(triangles, set, opening, eye, dice, sum);
            }
            for (const std::vector<int>& face : solid.faces) {  // and from the solid's own faces
                const Polygon loop = loop_of(solid, face);
                const Polygon piece = convex_pieces({loop, {}})[0];
                compare(triangles, set, opening, (0.5 * piece[0] + 0.3 * piece[1] + 0.2 * piece[2]), dice, sum);
            }
        }
        EXPECT_EQ(sum.disagreements, 0);
        EXPECT_GT(sum.penumbra, 30);
        EXPECT_GT(sum.umbra, 10);
        EXPECT_GT(sum.lit, 30);
    }
}

TEST(ConvexCells, a_receiver_in_a_concave_corner_sees_out_of_it) {
    Dice dice(53);
    const ClosedSolid solid = l_shape();
    const std::vector<Polygon> triangles = triangles_of(solid);
    const OccluderSet set = set_of(convex_cells(solid.vertices, solid.faces));
    Agreement sum;
    const Polygon wall = {{2, 0, 0}, {2, 0, 2}, {2, 2, 2}, {2, 2, 0}};
    for (const double z : {0.01, 0.1, 0.39}) {
        for (const Vec2 beside : {Vec2{1e-3, 1e-3}, Vec2{0.1, 0.0}, Vec2{0.0, 0.2}}) {
            compare(triangles, set, wall, {0.5 + beside.x, 0.5 + beside.y, z}, dice, sum);
        }
    }
    EXPECT_EQ(sum.disagreements, 0);
    const Receiver on_leg{{0.5, 0.7, 0.2}, {1, 0, 0}, {}};
    std::vector<BodyIndex> found;
    const Polygon seen = {{2, 0.6, 0}, {2, 0.6, 2}, {2, 2, 2}, {2, 2, 0}};
    set.between(on_leg.position, seen, found);
    EXPECT_NEAR(visible_configuration_factor(seen, on_leg, set, found), configuration_factor(seen, on_leg), 1e-14);
}

TEST(ConvexCells, no_light_leaks_through_the_cuts_between_cells) {
    for (const ClosedSolid& solid : {l_shape(), c_profile(), frame(), bowl()}) {
        const std::vector<Polygon> triangles = triangles_of(solid);
        const OccluderSet set = set_of(convex_cells(solid.vertices, solid.faces));
        // Lines in the planes of all faces, where the cuts lie; off the surface itself.
        Dice dice(55);
        int tried = 0;
        for (const std::vector<int>& face : solid.faces) {
            const Polygon loop = loop_of(solid, face);
            const Vec3 normal = unit_normal(loop);
            const Vec3 x = glm::normalize(loop[1] - loop[0]), y = glm::cross(normal, x);
            for (int k = 0; k < 1000; ++k) {
                const Vec3 from = loop[0] + dice.uniform(-3, 3) * x + dice.uniform(-3, 3) * y;
                const Vec3 to = loop[0] + dice.uniform(-3, 3) * x + dice.uniform(-3, 3) * y;
                const Vec3 aside = 1e-5 * normal;
                const bool above = is_blocked(triangles, from + aside, to + aside);
                const bool below = is_blocked(triangles, from - aside, to - aside);
                if (!above || !below) continue;
                ++tried;
                EXPECT_TRUE(set.blocks(from, to));
            }
        }
        EXPECT_GT(tried, 100);
    }
}

}  // namespace
}  // namespace hanei
