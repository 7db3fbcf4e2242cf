#include "engine/base/tolerance.h"
#include "engine/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace hanei {

namespace {

using Loop = std::vector<std::size_t>;  ///< numbers of points, counter-clockwise

/// The region's points in its own plane, and the points themselves.
struct Flattened {
    std::vector<Vec2> flat;
    std::vector<Vec3> points;
};

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

Loop add_loop(const Polygon& polygon, const Vec3& origin, const Vec3& x, const Vec3& y, Flattened& to) {
    Loop loop;
    for (const Vec3& point : polygon) {
        loop.push_back(to.points.size());
        to.points.push_back(point);
        to.flat.emplace_back(glm::dot(point - origin, x), glm::dot(point - origin, y));
    }
    return loop;
}

bool in_triangle(const Vec2& p, const Vec2& a, const Vec2& b, const Vec2& c) {
    return turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
}

/// True when the open segment crosses an edge of the loop that does not share an end with it.
bool crosses(const Flattened& in, const Loop& loop, std::size_t from, std::size_t to) {
    const Vec2 &p = in.flat[from], &q = in.flat[to];
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec2& a = in.flat[loop[k]];
        const Vec2& b = in.flat[loop[(k + 1) % loop.size()]];
        if (a == p || a == q || b == p || b == q) continue;
        const double pa = turn(p, q, a), pb = turn(p, q, b), ap = turn(a, b, p), aq = turn(a, b, q);
        if (((pa >= 0.0) != (pb >= 0.0) || pa == 0.0 || pb == 0.0) && (ap >= 0.0) != (aq >= 0.0)) return true;
    }
    return false;
}

/// True when the direction from corner k of the loop to `target` starts inside the region.
bool starts_inside(const Flattened& in, const Loop& loop, std::size_t k, const Vec2& target) {
    const Vec2& here = in.flat[loop[k]];
    const Vec2& before = in.flat[loop[(k + loop.size() - 1) % loop.size()]];
    const Vec2& after = in.flat[loop[(k + 1) % loop.size()]];
    const bool left_of_both = turn(before, here, target) > 0.0 && turn(here, after, target) > 0.0;
    const bool left_of_one = turn(before, here, target) > 0.0 || turn(here, after, target) > 0.0;
    return turn(before, here, after) >= 0.0 ? left_of_both : left_of_one;
}

/// Joins a hole to the outline by a bridge to the nearest corner that sees it.
bool bridge(const Flattened& in, Loop& outline, const Loop& hole, const std::vector<Loop>& others) {
    double nearest = std::numeric_limits<double>::max();
    std::pair<std::size_t, std::size_t> ends;
    for (std::size_t j = 0; j < hole.size(); ++j) {
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const double distance = glm::distance(in.flat[outline[k]], in.flat[hole[j]]);
            if (distance >= nearest || !starts_inside(in, outline, k, in.flat[hole[j]])) continue;
            bool free = !crosses(in, outline, outline[k], hole[j]) && !crosses(in, hole, outline[k], hole[j]);
            for (const Loop& other : others) free = free && !crosses(in, other, outline[k], hole[j]);
            if (!free) continue;
            nearest = distance;
            ends = {k, j};
        }
    }
    if (nearest == std::numeric_limits<double>::max()) return false;
    Loop joined(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(ends.first) + 1);
    for (std::size_t j = 0; j <= hole.size(); ++j) joined.push_back(hole[(ends.second + j) % hole.size()]);
    joined.insert(joined.end(), outline.begin() + static_cast<std::ptrdiff_t>(ends.first), outline.end());
    outline = std::move(joined);
    return true;
}

bool is_ear(const Flattened& in, const Loop& loop, std::size_t k, double no_turn) {
    const Vec2& a = in.flat[loop[(k + loop.size() - 1) % loop.size()]];
    const Vec2& b = in.flat[loop[k]];
    const Vec2& c = in.flat[loop[(k + 1) % loop.size()]];
    if (turn(a, b, c) <= no_turn) return false;
    return std::ranges::none_of(loop, [&](std::size_t other) {
        const Vec2& p = in.flat[other];
        return p != a && p != b && p != c && in_triangle(p, a, b, c);
    });
}

std::vector<Loop> ears(const Flattened& in, Loop loop, double no_turn) {
    std::vector<Loop> triangles;
    while (loop.size() > 3) {
        std::optional<std::size_t> ear;
        double widest = -1.0;  // the ear with the widest smallest side keeps slivers away
        for (std::size_t k = 0; k < loop.size(); ++k) {
            if (!is_ear(in, loop, k, no_turn)) continue;
            const Vec2& a = in.flat[loop[(k + loop.size() - 1) % loop.size()]];
            const Vec2& b = in.flat[loop[k]];
            const Vec2& c = in.flat[loop[(k + 1) % loop.size()]];
            const double width = turn(a, b, c) / glm::distance(a, c);
            if (width > widest) widest = width, ear = k;
        }
        if (ear) {
            triangles.push_back(
                {loop[(*ear + loop.size() - 1) % loop.size()], loop[*ear], loop[(*ear + 1) % loop.size()]});
        } else {  // only straight corners are left: drop the straightest
            ear = 0;
            double straightest = std::numeric_limits<double>::max();
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const double bend = std::abs(turn(in.flat[loop[(k + loop.size() - 1) % loop.size()]], in.flat[loop[k]],
                                                  in.flat[loop[(k + 1) % loop.size()]]));
                if (bend < straightest) straightest = bend, ear = k;
            }
        }
        loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(*ear));
    }
    if (turn(in.flat[loop[0]], in.flat[loop[1]], in.flat[loop[2]]) > no_turn) triangles.push_back(loop);
    return triangles;
}

/// `a` and `b` joined over a shared edge, when that is convex.
std::optional<Loop> joined(const Flattened& in, const Loop& a, const Loop& b, double no_turn) {
    for (std::size_t k = 0; k < a.size(); ++k) {
        for (std::size_t j = 0; j < b.size(); ++j) {
            if (a[k] != b[(j + 1) % b.size()] || a[(k + 1) % a.size()] != b[j]) continue;
            Loop both;
            for (std::size_t i = 1; i <= a.size(); ++i) both.push_back(a[(k + i) % a.size()]);
            for (std::size_t i = 2; i < b.size(); ++i) both.push_back(b[(j + i) % b.size()]);
            for (std::size_t i = 0; i < both.size(); ++i) {
                if (turn(in.flat[both[i]], in.flat[both[(i + 1) % both.size()]], in.flat[both[(i + 2) % both.size()]]) <
                    -no_turn) {
                    return std::nullopt;
                }
            }
            return both;
        }
    }
    return std::nullopt;
}

void merge_while_convex(const Flattened& in, std::vector<Loop>& loops, double no_turn) {
    for (std::size_t k = 0; k < loops.size(); ++k) {
        for (std::size_t j = k + 1; j < loops.size();) {
            std::optional<Loop> both = joined(in, loops[k], loops[j], no_turn);
            if (!both) {
                ++j;
                continue;
            }
            loops[k] = std::move(*both);
            loops.erase(loops.begin() + static_cast<std::ptrdiff_t>(j));
            j = k + 1;
        }
    }
}

}  // namespace

std::vector<Polygon> convex_pieces(const Region& region) {
    const Vec3 normal = unit_normal(region.outline);
    if (normal == Vec3{0.0}) return {};
    if (region.holes.empty() && is_convex(region.outline, normal)) return {region.outline};

    const Vec3 helper = std::abs(normal.x) < 0.7 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
    const Vec3 x = glm::normalize(glm::cross(helper, normal));
    const Vec3 y = glm::cross(normal, x);
    Flattened in;
    const Vec3& origin = region.outline[0];
    Loop outline = add_loop(region.outline, origin, x, y, in);
    std::vector<Loop> holes;
    for (const Polygon& hole : region.holes) {
        if (hole.size() < 3 || unit_normal(hole) == Vec3{0.0}) continue;
        holes.push_back(add_loop(hole, origin, x, y, in));
        if (glm::dot(vector_area(hole), normal) > 0.0) std::ranges::reverse(holes.back());
    }
    // Holes whose bridge is blocked by other holes are tried again once those are joined.
    for (bool progress = true; progress && !holes.empty();) {
        progress = false;
        for (std::size_t k = 0; k < holes.size() && !progress; ++k) {
            std::vector<Loop> others = holes;
            others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
            progress = bridge(in, outline, holes[k], others);
            if (progress) holes = std::move(others);
        }
    }
    const double extent = diameter(region.outline);
    const double no_turn = tolerance::no_area * extent * extent;
    std::vector<Loop> loops = ears(in, outline, no_turn);
    merge_while_convex(in, loops, no_turn);

    std::vector<Polygon> pieces;
    for (const Loop& loop : loops) {
        Polygon& piece = pieces.emplace_back();
        for (const std::size_t number : loop) piece.push_back(in.points[number]);
    }
    return pieces;
}

}  // namespace hanei
