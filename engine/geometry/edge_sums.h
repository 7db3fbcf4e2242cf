/// The sums over edges that form factors are made of, four edges at a time.
#pragma once

#include "engine/base/vector.h"
#include "engine/geometry/contour.h"

namespace hanei {

/// How many numbers a register of the machine holds. The bits of the sums do not depend on it.
enum class Registers { two, four };
Registers registers_here();

/// Lambert's sum as it stands, 1 / (2 pi) sum of gamma n . (b x a) / |b x a|: for loops about as large
/// as they are far.
///
/// Needs     a loop above the horizon of `normal`, off the origin.
/// Holds     a few roundings of the sum's greatest term, 1e-16; of small, far loops that leaves
///           little, see `far_sum`.
/// Cost      8 ns an edge for quadrilaterals (four-number registers), no branch, no allocation.
double near_sum(const SeenLoop& loop, const Vec3& normal, Registers registers = registers_here());

/// The same around the loop's middle m, given with the loop's offsets and as the receiver sees it.
/// With u the offsets from there, e = u_b - u_a, D = m.m and an edge's angle over its cross product
/// written as (1 + v) / D, what cancels in the sum cancels on paper:
///
///     F = -(m.S)(m.n) / (pi D^2) + 1/(2 pi D) sum over edges  v' (m x n).e + v n.(u_b x u_a)
///
/// with S the vector area and v' = v + m.(u_a + u_b) / D, both v and v' formed from small terms. The
/// first part is the inverse square law, the sum is smaller by the ratio of size and distance.
///
/// Needs     every u shorter than sin 45 of m, so that every edge subtends less than a right angle.
/// Holds     a few roundings of F where both cosines are about 1, for any size over distance.
/// Cost      15 ns an edge for quadrilaterals.
double far_sum(const SeenLoop& loop, const Vec3& middle, const Vec3& seen_middle, const Vec3& normal,
               Registers registers = registers_here());

}  // namespace hanei
