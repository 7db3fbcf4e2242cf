#include "engine/transport/closure.h"

#include <cmath>

namespace hanei {

double visible_sum(std::span<const float> factors, std::span<const float> shares) {
    if (shares.empty()) return 0.0;
    const std::size_t a_share = factors.size() / shares.size();
    double sum = 0.0;
    for (std::size_t j = 0; j < factors.size(); ++j)
        sum += static_cast<double>(factors[j]) * static_cast<double>(shares[j / a_share]);
    return sum;
}

void close_row(std::span<float> factors, std::span<const float> shares, double sum) {
    const double scale = sum / visible_sum(factors, shares);
    if (!std::isfinite(scale)) return;
    for (float& factor : factors) factor = static_cast<float>(static_cast<double>(factor) * scale);
}

}  // namespace hanei
