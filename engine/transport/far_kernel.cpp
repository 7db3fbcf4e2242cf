#include "engine/transport/far_kernel.h"

namespace hanei {

namespace {

#define HANEI_INLINE [[gnu::always_inline]] inline

/// What of the kernel is the same for all points.
struct Seen {
    float u, v, normal_u, normal_v, sunk, square, height;

    HANEI_INLINE explicit Seen(const FlatReceiver& r)
        : u(r.u),
          v(r.v),
          normal_u(r.normal_u),
          normal_v(r.normal_v),
          sunk(r.normal_height * r.height),
          square(r.height * r.height),
          height(r.height) {}

    HANEI_INLINE float kernel(float at_u, float at_v) const {
        const float du = at_u - u, dv = at_v - v;
        const float rising = (normal_u * du + normal_v * dv) - sunk;
        const float distance = (du * du + dv * dv) + square;
        return (rising > 0.0F ? rising : 0.0F) / (distance * distance);
    }
};

HANEI_INLINE void points_by(const FlatReceiver& receiver, std::span<const float> u, std::span<const float> v,
                            std::span<const float> weights, float* __restrict sums) {
    const Seen seen(receiver);
    const float* __restrict at_u = u.data(), * __restrict at_v = v.data(), * __restrict weight = weights.data();
    for (std::size_t k = 0; k < weights.size(); ++k) {
        sums[k] = (seen.height * weight[k]) * seen.kernel(at_u[k], at_v[k]);
    }
}

HANEI_INLINE void fours_by(const FlatReceiver& receiver, const std::array<const float*, 4>& u,
                           const std::array<const float*, 4>& v, std::span<const float> weights,
                           float* __restrict sums) {
    const Seen seen(receiver);
    const float* __restrict u0 = u[0], * __restrict u1 = u[1], * __restrict u2 = u[2], * __restrict u3 = u[3];
    const float* __restrict v0 = v[0], * __restrict v1 = v[1], * __restrict v2 = v[2], * __restrict v3 = v[3];
    const float* __restrict weight = weights.data();
    for (std::size_t k = 0; k < weights.size(); ++k) {
        const float sum = (seen.kernel(u0[k], v0[k]) + seen.kernel(u1[k], v1[k])) +
                          (seen.kernel(u2[k], v2[k]) + seen.kernel(u3[k], v3[k]));
        sums[k] = (seen.height * weight[k]) * sum;
    }
}

HANEI_INLINE float sum_by(const FlatReceiver& receiver, std::span<const EightPoints> points) {
    const Seen seen(receiver);
    std::array<float, 8> sums{};
    for (const EightPoints& eight : points) {
        for (std::size_t q = 0; q < 8; ++q) sums[q] += eight.weights[q] * seen.kernel(eight.u[q], eight.v[q]);
    }
    return seen.height * (((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7])));
}

HANEI_INLINE std::array<float, 4> sums_by(const FlatReceiver& receiver, std::span<const EightPoints> points,
                                          const FourSums* weights) {
    const Seen seen(receiver);
    std::array<float, 4> even{}, odd{};
    for (const EightPoints& eight : points) {
        const FourSums& weight = *weights++;
        std::array<float, 8> values;
        for (std::size_t q = 0; q < 8; ++q) values[q] = seen.kernel(eight.u[q], eight.v[q]);
        for (std::size_t q = 0; q < 8; q += 2) {
            for (std::size_t k = 0; k < 4; ++k) even[k] += weight[q][k] * values[q];
            for (std::size_t k = 0; k < 4; ++k) odd[k] += weight[q + 1][k] * values[q + 1];
        }
    }
    std::array<float, 4> total;
    for (std::size_t k = 0; k < 4; ++k) {
        const float sum = seen.height * (even[k] + odd[k]);
        total[k] = sum > 0.0F ? sum : 0.0F;
    }
    return total;
}

#if defined(__x86_64__)
#define HANEI_WIDE [[gnu::target("avx2")]]
const bool wide_registers = __builtin_cpu_supports("avx2");
#else
#define HANEI_WIDE
constexpr bool wide_registers = false;
#endif

HANEI_WIDE void points_wide(const FlatReceiver& receiver, std::span<const float> u, std::span<const float> v,
                            std::span<const float> weights, float* sums) {
    points_by(receiver, u, v, weights, sums);
}
HANEI_WIDE void fours_wide(const FlatReceiver& receiver, const std::array<const float*, 4>& u,
                           const std::array<const float*, 4>& v, std::span<const float> weights, float* sums) {
    fours_by(receiver, u, v, weights, sums);
}
HANEI_WIDE float sum_wide(const FlatReceiver& receiver, std::span<const EightPoints> points) {
    return sum_by(receiver, points);
}
HANEI_WIDE std::array<float, 4> sums_wide(const FlatReceiver& receiver, std::span<const EightPoints> points,
                                          const FourSums* weights) {
    return sums_by(receiver, points, weights);
}

}  // namespace

void kernel_at_points(const FlatReceiver& receiver, std::span<const float> u, std::span<const float> v,
                      std::span<const float> weights, float* sums) {
    wide_registers ? points_wide(receiver, u, v, weights, sums) : points_by(receiver, u, v, weights, sums);
}

void kernel_at_fours(const FlatReceiver& receiver, const std::array<const float*, 4>& u,
                     const std::array<const float*, 4>& v, std::span<const float> weights, float* sums) {
    wide_registers ? fours_wide(receiver, u, v, weights, sums) : fours_by(receiver, u, v, weights, sums);
}

float kernel_sum(const FlatReceiver& receiver, std::span<const EightPoints> points) {
    return wide_registers ? sum_wide(receiver, points) : sum_by(receiver, points);
}

std::array<float, 4> kernel_sums(const FlatReceiver& receiver, std::span<const EightPoints> points,
                                 const FourSums* weights) {
    return wide_registers ? sums_wide(receiver, points, weights) : sums_by(receiver, points, weights);
}

}  // namespace hanei
