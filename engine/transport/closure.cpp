#include "engine/transport/closure.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cmath>

namespace hanei {

namespace {

double visible_sum(const DenseRows& factors, const Visibility& visibility, std::size_t k) {
    const std::span<const float> row = factors.row(k);
    double sum = 0.0;
    for (std::size_t j = 0; j < row.size(); ++j) {
        const double share = visibility.all_visible ? 1.0 : static_cast<double>(visibility.share.row(k)[j]);
        sum += static_cast<double>(row[j]) * share;
    }
    return sum;
}

}  // namespace

std::optional<std::vector<double>> seen_sums(const Mesh& mesh, std::span<const Receiver> receivers,
                                             const OccluderSet& occluders, const Work& work) {
    constexpr std::size_t rows_at_once = 1024;  // the rows themselves are not kept
    std::vector<double> sums;
    for (std::size_t first = 0; first < receivers.size(); first += rows_at_once) {
        const auto some = receivers.subspan(first, std::min(rows_at_once, receivers.size() - first));
        const Work part{work.threads, work.stop, nullptr};
        const std::optional<DenseRows> factors = patch_factors(mesh, some, part);
        if (!factors) return std::nullopt;
        const std::optional<Visibility> visibility = patch_visibility(mesh, some, occluders, part);
        if (!visibility) return std::nullopt;
        for (std::size_t k = 0; k < some.size(); ++k) sums.push_back(visible_sum(*factors, *visibility, k));
    }
    return sums;
}

void close_rows(DenseRows& factors, const Visibility& visibility, std::span<const double> sums) {
    HANEI_CHECK(sums.size() == factors.rows);
    for (std::size_t k = 0; k < factors.rows; ++k) {
        const double sum = visible_sum(factors, visibility, k);
        const double scale = sums[k] / sum;
        if (!(sum > 0.0) || !std::isfinite(scale)) continue;
        const auto begin = factors.values.begin() + static_cast<std::ptrdiff_t>(k * factors.columns);
        std::transform(begin, begin + static_cast<std::ptrdiff_t>(factors.columns), begin,
                       [&](float factor) { return static_cast<float>(static_cast<double>(factor) * scale); });
    }
}

}  // namespace hanei
