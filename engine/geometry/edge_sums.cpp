#include "engine/geometry/edge_sums.h"

#include "engine/geometry/quartet.h"
#include "engine/geometry/quartet_angle.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace hanei {

namespace {

using std::numbers::pi;

/// Angle over its tangent, less one, from the tangent's square: by the quarter of the angle, from small
/// terms, so that it keeps its digits as the angle goes to zero.
HANEI_QUARTET Quartet angle_over_tangent_less_one(const Quartet& square) {
    const Quartet share = 1.0 / (1.0 + root(1.0 + square));
    const Quartet more = square * share;  // root - 1
    const Quartet half_square = more * share;
    const Quartet half_share = 1.0 / (1.0 + root(1.0 + half_square));
    const Quartet half_more = half_square * half_share;
    const Quartet quarter_square = half_more * half_share;
    const Quartet curved = 4.0 * (quarter_square * arc_tangent_series(quarter_square));
    return (curved - 2.0 * (more + half_more) - more * half_more) * (share * half_share);
}

/// Four edges of a loop, with a and b their ends less `from`; past the last edge, edges without length.
struct Edges {
    QuartetVec a, b;

    HANEI_QUARTET Edges(const SeenLoop& loop, std::size_t first, const Vec3& from) {
        const std::size_t last = loop.size() - 1;
        std::array<Vec3, 5> points;
        points[0] = loop.offsets[first == 0 ? last : first - 1] - from;
        for (std::size_t k = 0; k < 4; ++k) points[k + 1] = loop.offsets[std::min(first + k, last)] - from;
        const auto& [p, q, r, s, t] = points;
        a = {Quartet{p.x, q.x, r.x, s.x}, Quartet{p.y, q.y, r.y, s.y}, Quartet{p.z, q.z, r.z, s.z}};
        b = {Quartet{q.x, r.x, s.x, t.x}, Quartet{q.y, r.y, s.y, t.y}, Quartet{q.z, r.z, s.z, t.z}};
    }
};

HANEI_QUARTET double near_sum_by(const SeenLoop& loop, const Vec3& normal) {
    Quartet sum = quartet(0.0);
    for (std::size_t k = 0; k < loop.size(); k += 4) {
        const Edges offsets(loop, k, Vec3{0.0});
        const QuartetVec a = quartet(loop.first) + offsets.a, b = quartet(loop.first) + offsets.b;
        const QuartetVec across = cross(offsets.b - offsets.a, a);
        const Quartet square = dot(across, across), along = dot(a, b);
        // The tangent of half the angle, or of half its supplement, then of a quarter.
        const Quartet away = along < 0.0 ? -along : along;
        const Quartet per_half = 1.0 / (root(square + along * along) + away);
        const Quartet half_square = square * per_half * per_half;
        const Quartet share = 1.0 / (1.0 + root(1.0 + half_square));
        const Quartet quarter_square = half_square * share * share;
        const Quartet acute = (4.0 + 4.0 * (quarter_square * arc_tangent_series(quarter_square))) * (per_half * share);
        const Quartet angle_over_cross = along < 0.0 ? pi / root(square) - acute : acute;
        sum += square > 0.0 ? angle_over_cross * dot(across, quartet(normal)) : quartet(0.0);
    }
    return sum_of(sum) / (2.0 * pi);
}

HANEI_QUARTET double far_sum_by(const SeenLoop& loop, const Vec3& middle, const Vec3& seen_middle, const Vec3& normal) {
    const double inverse = 1.0 / glm::dot(seen_middle, seen_middle);
    const QuartetVec m = quartet(seen_middle), n = quartet(normal), sideways = quartet(glm::cross(seen_middle, normal));
    QuartetVec twice_area = quartet(Vec3{0.0});
    Quartet sum = quartet(0.0);
    for (std::size_t k = 0; k < loop.size(); k += 4) {
        const auto [a, b] = Edges(loop, k, middle);
        const QuartetVec edge = b - a, turn = cross(a, b);
        const QuartetVec across = cross(edge, m) - turn;  // b x a as the receiver sees them
        const Quartet linear = dot(m, a + b) * inverse, rest = dot(a, b) * inverse;
        const Quartet excess = linear + rest;  // the ends' dot product is D (1 + excess)
        const Quartet share = 1.0 / (1.0 + excess);
        const Quartet per_dot = share * inverse;
        const Quartet less = angle_over_tangent_less_one(dot(across, across) * per_dot * per_dot);
        const Quartet v = (less - excess) * share;
        const Quartet v_rest = (less - rest + excess * linear) * share;
        sum += v_rest * dot(sideways, edge) - v * dot(n, turn);
        twice_area = twice_area + turn;
    }
    const double point_like = -glm::dot(seen_middle, sum_of(twice_area)) * glm::dot(seen_middle, normal) * inverse;
    return (point_like + sum_of(sum)) * inverse / (2.0 * pi);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] double near_sum_wide(const SeenLoop& loop, const Vec3& normal) {
    return near_sum_by(loop, normal);
}
[[gnu::target("avx2")]] double far_sum_wide(const SeenLoop& loop, const Vec3& middle, const Vec3& seen_middle,
                                            const Vec3& normal) {
    return far_sum_by(loop, middle, seen_middle, normal);
}
const bool wide_registers = __builtin_cpu_supports("avx2");
#else
double near_sum_wide(const SeenLoop& loop, const Vec3& normal) { return near_sum_by(loop, normal); }
double far_sum_wide(const SeenLoop& loop, const Vec3& middle, const Vec3& seen_middle, const Vec3& normal) {
    return far_sum_by(loop, middle, seen_middle, normal);
}
const bool wide_registers = false;
#endif

}  // namespace

Registers registers_here() { return wide_registers ? Registers::four : Registers::two; }

double near_sum(const SeenLoop& loop, const Vec3& normal, Registers registers) {
    return registers == Registers::four ? near_sum_wide(loop, normal) : near_sum_by(loop, normal);
}

double far_sum(const SeenLoop& loop, const Vec3& middle, const Vec3& seen_middle, const Vec3& normal,
               Registers registers) {
    return registers == Registers::four ? far_sum_wide(loop, middle, seen_middle, normal)
                                        : far_sum_by(loop, middle, seen_middle, normal);
}

}  // namespace hanei
