#include "engine/transport/row_product.h"

#include "engine/transport/row_kernel.h"

#include <algorithm>
#include <cmath>

namespace hanei {

namespace row_kernel {

void run_plain(const Job& job, std::size_t sides) { run_any(job, sides); }

}  // namespace row_kernel

namespace {

bool has_wide() {
#if defined(__x86_64__)
    static const bool has = __builtin_cpu_supports("avx2");
    return has;
#else
    return false;
#endif
}

// Codes read as doubles are that much smaller than read as floats, which is what rows' scales are for.
constexpr int codes_below_floats = 1023 - 127;

}  // namespace

Columns::Columns(std::span<const double> interleaved, std::size_t sides, std::size_t length, RowFormat format)
    : back_(sides, 1.0), stride_((length + TileShape::block - 1) / TileShape::block * TileShape::block) {
    memory_.resize(sides * stride_ * sizeof(double));
    auto* numbers = reinterpret_cast<double*>(memory_.data());
    for (std::size_t s = 0; s < sides; ++s) {
        double* column = numbers + s * stride_;
        double greatest = 0.0;
        for (std::size_t j = 0; j < length; ++j) {
            column[j] = interleaved[j * sides + s];
            greatest = std::max(greatest, std::abs(column[j]));
        }
        if (format == RowFormat::exact || !(greatest > 0.0) || !std::isfinite(greatest)) continue;
        const int lift = codes_below_floats - std::ilogb(greatest);
        const double half = std::ldexp(1.0, lift / 2), rest = std::ldexp(1.0, lift - lift / 2);
        for (std::size_t j = 0; j < length; ++j) column[j] = column[j] * half * rest;  // the whole may be infinite
        back_[s] = std::ldexp(1.0, codes_below_floats - lift);
    }
    at_ = numbers;
}

void multiply_tile(const TileShape& shape, std::size_t count, std::span<const std::byte> factors,
                   std::span<const std::byte> shares, const Columns& leaving, double* arriving) {
    for (std::size_t first = 0; first < leaving.sides(); first += row_kernel::most_sides) {
        const std::size_t sides = std::min(row_kernel::most_sides, leaving.sides() - first);
        row_kernel::Job job{shape.format == RowFormat::exact,
                            shape.columns_a_share,
                            shape.blocks(),
                            count,
                            factors.data(),
                            factors.data() + shape.factors_at(),
                            shares.data(),
                            shares.data() + shape.shares_at(),
                            {},
                            {},
                            arriving + first,
                            leaving.sides()};
        for (std::size_t s = 0; s < sides; ++s) {
            job.leaving[s] = leaving[first + s];
            job.back[s] = leaving.back(first + s);
        }
#if defined(__x86_64__)
        if (has_wide()) {
            run_wide(job, sides);
            continue;
        }
#endif
        run_plain(job, sides);
    }
}

}  // namespace hanei
