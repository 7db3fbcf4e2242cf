/// References in 33 digits, for tests of the kernels: the textbook formulas, whose cancellation does
/// not matter there. g++ and libquadmath.
#pragma once

#include "engine/geometry/configuration_factor.h"

#include <algorithm>
#include <array>
#include <quadmath.h>
#include <span>
#include <utility>
#include <vector>

namespace hanei::testing {

__extension__ using Quad = __float128;

inline const Quad quad_pi = 4 * atanq(1);

struct QuadVec {
    Quad x = 0, y = 0, z = 0;
    QuadVec() = default;
    QuadVec(Quad x_, Quad y_, Quad z_) : x(x_), y(y_), z(z_) {}
    explicit QuadVec(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}
};
inline QuadVec operator+(const QuadVec& a, const QuadVec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline QuadVec operator-(const QuadVec& a, const QuadVec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline QuadVec operator*(const Quad& s, const QuadVec& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Quad dot(const QuadVec& a, const QuadVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Quad length(const QuadVec& a) { return sqrtq(dot(a, a)); }
inline QuadVec cross(const QuadVec& a, const QuadVec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// What of a loop seen from the origin is above the horizon.
inline std::vector<QuadVec> above_horizon(std::span<const QuadVec> seen, const QuadVec& normal) {
    std::vector<QuadVec> kept;
    for (std::size_t k = 0; k < seen.size(); ++k) {
        const QuadVec& a = seen[k];
        const QuadVec& b = seen[(k + 1) % seen.size()];
        const Quad here = dot(a, normal), there = dot(b, normal);
        if (here >= 0) kept.push_back(a);
        if ((here > 0 && there < 0) || (here < 0 && there > 0)) kept.push_back(a + (here / (here - there)) * (b - a));
    }
    return kept;
}

/// Lambert's sum over a loop seen from the origin: 0 from behind, never limited to 0 to 1.
inline Quad quad_factor(std::span<const QuadVec> seen, const QuadVec& normal) {
    QuadVec area;
    for (std::size_t k = 2; k < seen.size(); ++k) area = area + cross(seen[k - 1] - seen[0], seen[k] - seen[0]);
    if (dot(area, seen[0]) >= 0) return 0;
    const std::vector<QuadVec> kept = above_horizon(seen, normal);
    Quad sum = 0;
    for (std::size_t k = 0; k < kept.size(); ++k) {
        const QuadVec& a = kept[k];
        const QuadVec& b = kept[(k + 1) % kept.size()];
        const QuadVec across = cross(b, a);
        const Quad size = length(across);
        if (size > 0) sum += atan2q(size, dot(a, b)) * dot(across, normal) / size;
    }
    return sum / (2 * quad_pi);
}

/// The same for a receiver, moved by `aside`.
inline Quad quad_factor(std::span<const Vec3> polygon, const Receiver& receiver, const QuadVec& aside = {}) {
    std::vector<QuadVec> seen;
    for (const Vec3& corner : polygon) seen.push_back(QuadVec(corner) - QuadVec(receiver.position) - aside);
    return quad_factor(seen, QuadVec(receiver.normal));
}

/// Gauss's rule of 32 points on -1 to 1: nodes above zero and their weights.
inline const std::array<std::pair<Quad, Quad>, 16>& gauss_rule() {
    static const auto rule = [] {
        constexpr int n = 32;
        std::array<std::pair<Quad, Quad>, n / 2> made;
        for (int k = 0; k < n / 2; ++k) {
            Quad x = cosq(quad_pi * (k + Quad(3) / 4) / (n + Quad(1) / 2)), slope = 0;
            for (int step = 0; step < 8; ++step) {
                Quad before = 1, here = x;
                for (int degree = 2; degree <= n; ++degree) {
                    before = std::exchange(here, ((2 * degree - 1) * x * here - (degree - 1) * before) / degree);
                }
                slope = n * (x * here - before) / (x * x - 1);
                x -= here / slope;
            }
            made[static_cast<std::size_t>(k)] = {x, 2 / ((1 - x * x) * slope * slope)};
        }
        return made;
    }();
    return rule;
}

/// Illuminance from a diffuse tube of 1 cd/m across, integrated over the angle at the receiver.
inline Quad quad_tube(const Vec3& from, const Vec3& to, const Receiver& receiver) {
    const QuadVec normal(receiver.normal), at(receiver.position);
    QuadVec a = QuadVec(from) - at, b = QuadVec(to) - at;
    const Quad height_a = dot(a, normal), height_b = dot(b, normal);
    if (height_a <= 0 && height_b <= 0) return 0;
    if (height_a < 0) a = a + (height_a / (height_a - height_b)) * (b - a);
    if (height_b < 0) b = b + (height_b / (height_b - height_a)) * (a - b);
    const QuadVec whole = QuadVec(to) - QuadVec(from);
    const QuadVec along = (1 / length(whole)) * whole;
    const QuadVec foot = a - dot(a, along) * along;
    const Quad h = length(foot), start = dot(a, along), end = dot(b, along);
    if (h == 0) return 0;
    const Quad half = atan2q(h * (end - start), h * h + start * end) / 2;
    const Quad middle = atan2q(start, h) + half;
    Quad sum = 0;
    for (const auto& [node, weight] : gauss_rule()) {
        for (const Quad& angle : {middle - half * node, middle + half * node}) {
            const Quad c = cosq(angle);
            sum += weight * half * c * (c * dot(foot, normal) + h * sinq(angle) * dot(along, normal));
        }
    }
    return sum / (h * h);
}

}  // namespace hanei::testing
