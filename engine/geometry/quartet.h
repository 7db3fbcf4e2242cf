/// Four double precision numbers worked on at once. Every operation rounds each of them as it would alone, so that the
/// bits do not depend on how many of them a register of the machine holds.
#pragma once

#include "engine/base/vector.h"

#include <cmath>

namespace hanei {

using Quartet = double __attribute__((vector_size(32)));

struct QuartetVec {
    Quartet x, y, z;
};

/// Always inline: how wide the registers are is the caller's business.
#define HANEI_QUARTET [[gnu::always_inline]] inline

HANEI_QUARTET Quartet quartet(double value) { return Quartet{value, value, value, value}; }
HANEI_QUARTET QuartetVec quartet(const Vec3& v) { return {quartet(v.x), quartet(v.y), quartet(v.z)}; }
HANEI_QUARTET QuartetVec operator+(const QuartetVec& a, const QuartetVec& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HANEI_QUARTET QuartetVec operator-(const QuartetVec& a, const QuartetVec& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
HANEI_QUARTET Quartet dot(const QuartetVec& a, const QuartetVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
HANEI_QUARTET QuartetVec cross(const QuartetVec& a, const QuartetVec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
HANEI_QUARTET Quartet root(const Quartet& v) {
    return Quartet{std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])};
}
HANEI_QUARTET double sum_of(const Quartet& v) { return (v[0] + v[1]) + (v[2] + v[3]); }
HANEI_QUARTET Vec3 sum_of(const QuartetVec& v) { return {sum_of(v.x), sum_of(v.y), sum_of(v.z)}; }

}  // namespace hanei
