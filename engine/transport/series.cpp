#include "engine/transport/series.h"

#include "engine/base/tiles.h"
#include "engine/transport/sums.h"

#include <algorithm>
#include <limits>

namespace hanei {

namespace {

constexpr std::size_t rows_a_tile = 32;

// Row sums are known to the rounding of floats; a ratio this near to 1 says nothing.
constexpr double least_gap = 1e-6;

const float* shares_of(const Visibility* visibility, std::size_t row) {
    if (!visibility || visibility->all_visible) return nullptr;
    return visibility->share.row(row).data();
}

double row_product(std::span<const float> factors, const float* shares, std::span<const double> leaving) {
    const float* f = factors.data();
    const double* x = leaving.data();
    if (!shares) return sum_of(factors.size(), [=](std::size_t j) { return static_cast<double>(f[j]) * x[j]; });
    return sum_of(factors.size(),
                  [=](std::size_t j) { return static_cast<double>(f[j]) * static_cast<double>(shares[j]) * x[j]; });
}

}  // namespace

bool multiply(const DenseRows& factors, const Visibility* visibility, std::span<const double> leaving,
              std::span<double> arriving, const Work& work) {
    return for_each_tile(factors.rows, rows_a_tile, work, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            arriving[i] = row_product(factors.row(i), shares_of(visibility, i), leaving);
        }
    });
}

bool multiply(const DenseRows& factors, const Visibility* visibility, std::span<const double> leaving,
              std::span<double> arriving, std::size_t sides, const Work& work) {
    if (sides == 1) return multiply(factors, visibility, leaving, arriving, work);
    return for_each_tile(factors.rows, rows_a_tile, work, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::span<const float> row = factors.row(i);
            const float* shares = shares_of(visibility, i);
            double* sums = arriving.data() + i * sides;
            std::fill_n(sums, sides, 0.0);
            for (std::size_t j = 0; j < row.size(); ++j) {
                const double seen = static_cast<double>(row[j]) * (shares ? static_cast<double>(shares[j]) : 1.0);
                if (seen == 0.0) continue;
                for (std::size_t s = 0; s < sides; ++s) sums[s] += seen * leaving[j * sides + s];
            }
        }
    });
}

std::optional<RowSums> row_sums(const DenseRows& factors, const Visibility* visibility,
                                std::span<const double> reflectance, const Work& work) {
    RowSums sums;
    sums.plain.resize(factors.rows);
    sums.reflecting.resize(factors.rows);
    const std::vector<double> ones(factors.columns, 1.0);
    if (!multiply(factors, visibility, ones, sums.plain, work)) return std::nullopt;
    if (!multiply(factors, visibility, reflectance, sums.reflecting, work)) return std::nullopt;
    for (const double sum : sums.plain) sums.greatest_plain = std::max(sums.greatest_plain, sum);
    for (const double sum : sums.reflecting) sums.greatest = std::max(sums.greatest, sum);
    return sums;
}

Ratios ratios_of(std::span<const double> last, std::span<const double> before) {
    Ratios ratios{std::numeric_limits<double>::infinity(), 0.0};
    for (std::size_t k = 0; k < last.size(); ++k) {
        if (before[k] > 0.0) {
            const double ratio = last[k] / before[k];
            ratios.least = std::min(ratios.least, ratio);
            ratios.greatest = std::max(ratios.greatest, ratio);
        } else if (last[k] > 0.0) {
            ratios.greatest = std::numeric_limits<double>::infinity();
        }
    }
    if (ratios.least > ratios.greatest) ratios.least = 0.0;  // nothing was reflected at all
    return ratios;
}

void TailBounds::narrow(const Ratios& ratios, std::span<const double> last) {
    diverges_ = ratios.least >= 1.0 - least_gap;
    if (diverges_) return;
    const double low = ratios.least / (1.0 - ratios.least);
    bracket_ = ratios.greatest < 1.0 - least_gap;
    const double high = bracket_ ? ratios.greatest / (1.0 - ratios.greatest) : 0.0;
    for (std::size_t k = 0; k < last.size(); ++k) {
        low_[k] = std::max(low_[k], last[k] * low);
        if (bracket_) high_[k] = std::min(high_[k], last[k] * high);
        high_[k] = std::max(high_[k], low_[k]);  // where both are one number but for rounding
    }
}

double TailBounds::greatest_half_width() const {
    double found = 0.0;
    for (std::size_t k = 0; k < high_.size(); ++k) found = std::max(found, 0.5 * (high_[k] - low_[k]));
    return found;
}

TailBounds tail_by_row_sums(const RowSums& rows, double leaving) {
    std::vector<double> high(rows.plain.size(), leaving > 0.0 ? unbounded : 0.0);
    if (rows.greatest < 1.0 - least_gap) {
        const double later = rows.greatest_plain / (1.0 - rows.greatest);
        for (std::size_t k = 0; k < high.size(); ++k) {
            high[k] = std::min(unbounded, leaving * (rows.plain[k] + rows.reflecting[k] * later));
        }
    }
    return TailBounds(std::move(high));
}

}  // namespace hanei
