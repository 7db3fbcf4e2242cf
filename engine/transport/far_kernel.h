/// The kernel of the form factor at many points of a plane at once, in single precision:
///
///     K = (n . r) h / r^4
///
/// with r from the receiver to the point, n the receiver's normal and h its height over the plane; pi is
/// left to the weights. The bits do not depend on how many numbers a register of the machine holds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace hanei {

/// A receiver in the coordinates of a plane.
struct FlatReceiver {
    float u = 0.0F, v = 0.0F, height = 0.0F;
    float normal_u = 0.0F, normal_v = 0.0F, normal_height = 0.0F;
};

/// Eight points and what the kernel at each adds to a sum. Points to spare weigh nothing.
struct EightPoints {
    std::array<float, 8> u{}, v{};
    std::array<float, 8> weights{};
};
/// The same for four sums.
using FourSums = std::array<std::array<float, 4>, 8>;

/// sums[k] = weights[k] K at (u[k], v[k]), 0 behind the horizon.
/// Cost      0.4 ns a point (registers of eight).
void kernel_at_points(const FlatReceiver& receiver, std::span<const float> u, std::span<const float> v,
                      std::span<const float> weights, float* sums);

/// sums[k] = weights[k] x the sum of K at four points each.
void kernel_at_fours(const FlatReceiver& receiver, const std::array<const float*, 4>& u,
                     const std::array<const float*, 4>& v, std::span<const float> weights, float* sums);

/// Sum over eights of points, and four sums with weights of their own; none below 0.
float kernel_sum(const FlatReceiver& receiver, std::span<const EightPoints> points);
std::array<float, 4> kernel_sums(const FlatReceiver& receiver, std::span<const EightPoints> points,
                                 const FourSums* weights);

}  // namespace hanei
