#include "engine/transport/row_product.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace hanei {

namespace {

// Written for vector units of any width: lanes never meet before the end, and nothing is contracted,
// so that each way of compiling it gives the same bits.
#define HANEI_INLINE [[gnu::always_inline]] inline

using Floats = float __attribute__((vector_size(32)));
using Words = std::uint32_t __attribute__((vector_size(32)));
using Shorts = std::uint16_t __attribute__((vector_size(16)));
using Bytes = std::uint8_t __attribute__((vector_size(8)));
using Doubles = double __attribute__((vector_size(32)));

constexpr std::size_t lanes = 8;
constexpr std::size_t most_sides = 4;  // at once

template <class Vector>
HANEI_INLINE void load(const void* from, Vector& to) {
    std::memcpy(&to, from, sizeof to);
}

/// Eight numbers in two halves.
struct Halves {
    Doubles low, high;
};

HANEI_INLINE void widen(const Floats& from, Halves& to) {
    to.low = __builtin_convertvector(__builtin_shufflevector(from, from, 0, 1, 2, 3), Doubles);
    to.high = __builtin_convertvector(__builtin_shufflevector(from, from, 4, 5, 6, 7), Doubles);
}

/// How eight coefficients come out of a format. A code of 16 bits, moved to a float's upper bits, is a
/// number far below 1 that is normal or 0; times a share of 0 to 255 it is exact. The row's scale makes
/// up for both.
template <RowFormat format, std::size_t columns_a_share, BlockKind kind>
struct Eight;

template <std::size_t columns_a_share, BlockKind kind>
struct Eight<RowFormat::exact, columns_a_share, kind> {
    HANEI_INLINE static void read(const std::byte* factors, const std::byte* shares, std::size_t at, Halves& to) {
        Floats factor;
        load(factors + at * sizeof(float), factor);
        widen(factor, to);
        if constexpr (kind == BlockKind::veiled && columns_a_share == 1) {
            Floats share;
            Halves wide;
            load(shares + at * sizeof(float), share);
            widen(share, wide);
            to.low *= wide.low;
            to.high *= wide.high;
        } else if constexpr (kind == BlockKind::veiled) {
            float share[2];
            load(shares + at / 4 * sizeof(float), share);
            to.low *= static_cast<double>(share[0]);
            to.high *= static_cast<double>(share[1]);
        }
    }
};

template <std::size_t columns_a_share, BlockKind kind>
struct Eight<RowFormat::compact, columns_a_share, kind> {
    HANEI_INLINE static void read(const std::byte* factors, const std::byte* shares, std::size_t at, Halves& to) {
        Shorts code;
        load(factors + at * sizeof(std::uint16_t), code);
        const Words bits = __builtin_convertvector(code, Words) << 12U;
        Floats factor = reinterpret_cast<Floats>(bits);
        if constexpr (kind == BlockKind::veiled && columns_a_share == 1) {
            using Signed = std::int32_t __attribute__((vector_size(32)));  // which vector units turn into floats
            Bytes share;
            load(shares + at, share);
            factor *= __builtin_convertvector(__builtin_convertvector(share, Signed), Floats);
        } else if constexpr (kind == BlockKind::veiled) {
            const auto low = static_cast<float>(std::to_integer<int>(shares[at / 4]));
            const auto high = static_cast<float>(std::to_integer<int>(shares[at / 4 + 1]));
            factor *= Floats{low, low, low, low, high, high, high, high};
        } else {
            factor *= 255.0F;
        }
        widen(factor, to);
    }
};

template <std::size_t sides>
struct Sums {
    Doubles low[sides]{}, high[sides]{};
};

template <RowFormat format, std::size_t columns_a_share, BlockKind kind, std::size_t sides>
HANEI_INLINE void add_block(const std::byte* factors, const std::byte* shares, const double* const* leaving,
                            std::size_t column, Sums<sides>& sums) {
    Sums<sides> now = sums;
    for (std::size_t j = 0; j < TileShape::block; j += lanes) {
        Halves coefficients;
        Doubles low, high;
        Eight<format, columns_a_share, kind>::read(factors, shares, j, coefficients);
        for (std::size_t s = 0; s < sides; ++s) {
            load(leaving[s] + column + j, low);
            load(leaving[s] + column + j + lanes / 2, high);
            now.low[s] += coefficients.low * low;
            now.high[s] += coefficients.high * high;
        }
    }
    sums = now;
}

struct Job {
    const TileShape* shape;
    std::size_t count;
    const std::byte *factors, *shares;
    const double* leaving[most_sides];
    double* arriving;
    std::size_t stride;
};

template <RowFormat format, std::size_t columns_a_share, std::size_t sides>
HANEI_INLINE void run(const Job& job) {
    const TileShape& shape = *job.shape;
    const std::size_t factor_step = TileShape::block * shape.factor_size();
    const std::size_t share_step = shape.shares_a_block() * shape.share_size();
    const std::byte* factors = job.factors + shape.factors_at();
    const std::byte* shares = job.shares + shape.shares_at();
    const std::byte* kinds = job.shares;
    Sums<sides> sums[TileShape::rows];
    for (std::size_t b = 0; b < shape.blocks(); ++b) {
        for (std::size_t row = 0; row < TileShape::rows; ++row, factors += factor_step, ++kinds) {
            const auto kind = static_cast<BlockKind>(*kinds);
            const std::size_t column = b * TileShape::block;
            if (kind == BlockKind::clear) {
                add_block<format, columns_a_share, BlockKind::clear>(factors, shares, job.leaving, column, sums[row]);
            } else if (kind == BlockKind::veiled) {
                add_block<format, columns_a_share, BlockKind::veiled>(factors, shares, job.leaving, column, sums[row]);
                shares += share_step;
            }
        }
    }
    for (std::size_t row = 0; row < job.count; ++row) {
        double scale;
        load(job.factors + row * sizeof(double), scale);
        for (std::size_t s = 0; s < sides; ++s) {
            const Doubles sum = sums[row].low[s] + sums[row].high[s];
            job.arriving[row * job.stride + s] = scale * ((sum[0] + sum[2]) + (sum[1] + sum[3]));
        }
    }
}

template <RowFormat format, std::size_t columns_a_share>
HANEI_INLINE void run_sides(const Job& job, std::size_t sides) {
    if (sides == 1) run<format, columns_a_share, 1>(job);
    if (sides == 2) run<format, columns_a_share, 2>(job);
    if (sides == 3) run<format, columns_a_share, 3>(job);
    if (sides == 4) run<format, columns_a_share, 4>(job);
}

HANEI_INLINE void run_any(const Job& job, std::size_t sides) {
    const bool exact = job.shape->format == RowFormat::exact, one = job.shape->columns_a_share == 1;
    if (exact && one) run_sides<RowFormat::exact, 1>(job, sides);
    if (exact && !one) run_sides<RowFormat::exact, 4>(job, sides);
    if (!exact && one) run_sides<RowFormat::compact, 1>(job, sides);
    if (!exact && !one) run_sides<RowFormat::compact, 4>(job, sides);
}

void run_plain(const Job& job, std::size_t sides) { run_any(job, sides); }

#if defined(__x86_64__)
[[gnu::target("arch=x86-64-v3")]] void run_wide(const Job& job, std::size_t sides) { run_any(job, sides); }

void run_best(const Job& job, std::size_t sides) {
    static const bool wide = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2");
    wide ? run_wide(job, sides) : run_plain(job, sides);
}
#else
void run_best(const Job& job, std::size_t sides) { run_plain(job, sides); }
#endif

}  // namespace

Columns::Columns(std::span<const double> interleaved, std::size_t sides, std::size_t length)
    : sides_(sides), stride_((length + TileShape::block - 1) / TileShape::block * TileShape::block) {
    memory_.resize(sides * stride_ * sizeof(double));
    auto* numbers = reinterpret_cast<double*>(memory_.data());
    for (std::size_t j = 0; j < length; ++j) {
        for (std::size_t s = 0; s < sides; ++s) numbers[s * stride_ + j] = interleaved[j * sides + s];
    }
    at_ = numbers;
}

void multiply_tile(const TileShape& shape, std::size_t count, std::span<const std::byte> factors,
                   std::span<const std::byte> shares, const Columns& leaving, double* arriving) {
    for (std::size_t first = 0; first < leaving.sides(); first += most_sides) {
        const std::size_t sides = std::min(most_sides, leaving.sides() - first);
        Job job{&shape, count, factors.data(), shares.data(), {}, arriving + first, leaving.sides()};
        for (std::size_t s = 0; s < sides; ++s) job.leaving[s] = leaving[first + s];
        run_best(job, sides);
    }
}

}  // namespace hanei
