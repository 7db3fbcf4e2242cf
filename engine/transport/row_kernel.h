/// The product of a tile, written once and compiled for each kind of machine.
///
/// Lanes never meet before the end and nothing is contracted, so that every way of compiling it gives the
/// same bits. Included by sources that are compiled for machines the rest is not: it must call nothing
/// that another source may share (no inline function of a header but its own).
#pragma once

#include "engine/transport/stored_tile.h"

#include <cstddef>
#include <cstdint>
#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace hanei::row_kernel {

inline constexpr std::size_t most_sides = 4;  ///< at once

/// What a product needs, as plain numbers.
struct Job {
    bool exact;
    std::size_t columns_a_share, blocks, count;
    const std::byte *scales, *factors, *kinds, *shares;
    const double* leaving[most_sides];
    double back[most_sides];  ///< what a side's sums are multiplied with
    double* arriving;
    std::size_t stride;
};

/// On every machine; on those with 256 bit vectors.
void run_plain(const Job& job, std::size_t sides);
void run_wide(const Job& job, std::size_t sides);

namespace {

#define HANEI_INLINE [[gnu::always_inline]] inline

using Doubles = double __attribute__((vector_size(32)));
constexpr std::size_t lanes = 4;

template <class Vector>
HANEI_INLINE void load(const void* from, Vector& to) {
    __builtin_memcpy(&to, from, sizeof to);
}

HANEI_INLINE void read_floats(const std::byte* from, Doubles& to) {
#if defined(__AVX2__)
    to = _mm256_cvtps_pd(_mm_loadu_ps(reinterpret_cast<const float*>(from)));
#else
    using Floats = float __attribute__((vector_size(16)));
    Floats floats;
    load(from, floats);
    to = __builtin_convertvector(floats, Doubles);
#endif
}

/// A code of 16 bits, moved to a double's upper bits, is a number near the smallest that is normal, or 0.
HANEI_INLINE void read_codes(const std::byte* from, Doubles& to) {
#if defined(__AVX2__)
    const __m128i codes = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(from));
    to = _mm256_castsi256_pd(_mm256_slli_epi64(_mm256_cvtepu16_epi64(codes), 41));
#else
    using Shorts = std::uint16_t __attribute__((vector_size(8)));
    using Words = std::uint64_t __attribute__((vector_size(32)));
    Shorts codes;
    load(from, codes);
    const Words bits = __builtin_convertvector(codes, Words) << 41U;
    load(&bits, to);
#endif
}

HANEI_INLINE void read_bytes(const std::byte* from, Doubles& to) {
#if defined(__AVX2__)
    int four;
    load(from, four);
    to = _mm256_cvtepi32_pd(_mm_cvtepu8_epi32(_mm_cvtsi32_si128(four)));
#else
    using Bytes = std::uint8_t __attribute__((vector_size(4)));
    using Words = std::int32_t __attribute__((vector_size(16)));
    Bytes bytes;
    load(from, bytes);
    to = __builtin_convertvector(__builtin_convertvector(bytes, Words), Doubles);
#endif
}

template <bool exact, std::size_t columns_a_share, bool veiled>
HANEI_INLINE void read_four(const std::byte* factors, const std::byte* shares, std::size_t at, Doubles& to) {
    if constexpr (exact) {
        read_floats(factors + at * sizeof(float), to);
    } else {
        read_codes(factors + at * sizeof(std::uint16_t), to);
    }
    if constexpr (veiled && columns_a_share == 1) {
        Doubles share;
        if constexpr (exact) {
            read_floats(shares + at * sizeof(float), share);
        } else {
            read_bytes(shares + at, share);
        }
        to *= share;
    } else if constexpr (veiled && exact) {
        float share;
        load(shares + at / lanes * sizeof(float), share);
        to *= static_cast<double>(share);
    } else if constexpr (veiled) {
        to *= static_cast<double>(static_cast<int>(shares[at / lanes]));
    }
}

template <std::size_t sides>
struct Sums {
    Doubles low[sides], high[sides];
};

/// Shares of whole blocks in full view are left out of the sum over the block, and put in after it.
template <bool exact, std::size_t columns_a_share, bool veiled, std::size_t sides>
HANEI_INLINE void add_block(const std::byte* factors, const std::byte* shares, const double* const* leaving,
                            std::size_t column, Sums<sides>& sums) {
    constexpr bool apart = !exact && !veiled;
    Sums<sides> now = sums;
    if constexpr (apart) now = Sums<sides>{};
    for (std::size_t j = 0; j < TileShape::block; j += 2 * lanes) {
        Doubles low, high, number;
        read_four<exact, columns_a_share, veiled>(factors, shares, j, low);
        read_four<exact, columns_a_share, veiled>(factors, shares, j + lanes, high);
        for (std::size_t s = 0; s < sides; ++s) {
            load(leaving[s] + column + j, number);
            now.low[s] += low * number;
            load(leaving[s] + column + j + lanes, number);
            now.high[s] += high * number;
        }
    }
    for (std::size_t s = 0; s < sides; ++s) {
        sums.low[s] = apart ? sums.low[s] + 255.0 * now.low[s] : now.low[s];
        sums.high[s] = apart ? sums.high[s] + 255.0 * now.high[s] : now.high[s];
    }
}

template <bool exact, std::size_t columns_a_share, std::size_t sides>
HANEI_INLINE void run(const Job& job) {
    constexpr std::size_t factor_step = TileShape::block * (exact ? sizeof(float) : sizeof(std::uint16_t));
    constexpr std::size_t share_step = TileShape::block / columns_a_share * (exact ? sizeof(float) : 1);
    const std::byte *factors = job.factors, *shares = job.shares, *kinds = job.kinds;
    Sums<sides> sums[TileShape::rows] = {};
    for (std::size_t b = 0; b < job.blocks; ++b) {
        const std::size_t column = b * TileShape::block;
        for (std::size_t row = 0; row < TileShape::rows; ++row, factors += factor_step, ++kinds) {
            const auto kind = static_cast<BlockKind>(*kinds);
            if (kind == BlockKind::clear) {
                add_block<exact, columns_a_share, false>(factors, shares, job.leaving, column, sums[row]);
            } else if (kind == BlockKind::veiled) {
                add_block<exact, columns_a_share, true>(factors, shares, job.leaving, column, sums[row]);
                shares += share_step;
            }
        }
    }
    for (std::size_t row = 0; row < job.count; ++row) {
        double scale;
        load(job.scales + row * sizeof(double), scale);
        for (std::size_t s = 0; s < sides; ++s) {
            const Doubles sum = sums[row].low[s] + sums[row].high[s];
            job.arriving[row * job.stride + s] = job.back[s] * (scale * ((sum[0] + sum[2]) + (sum[1] + sum[3])));
        }
    }
}

template <bool exact, std::size_t columns_a_share>
HANEI_INLINE void run_sides(const Job& job, std::size_t sides) {
    if (sides == 1) run<exact, columns_a_share, 1>(job);
    if (sides == 2) run<exact, columns_a_share, 2>(job);
    if (sides == 3) run<exact, columns_a_share, 3>(job);
    if (sides == 4) run<exact, columns_a_share, 4>(job);
}

HANEI_INLINE void run_any(const Job& job, std::size_t sides) {
    if (job.exact && job.columns_a_share == 1) run_sides<true, 1>(job, sides);
    if (job.exact && job.columns_a_share == 4) run_sides<true, 4>(job, sides);
    if (!job.exact && job.columns_a_share == 1) run_sides<false, 1>(job, sides);
    if (!job.exact && job.columns_a_share == 4) run_sides<false, 4>(job, sides);
}

#undef HANEI_INLINE

}  // namespace

}  // namespace hanei::row_kernel
