/// Sums whose order never changes, fast enough to be taken everywhere.
#pragma once

#include <array>
#include <cstddef>

namespace hanei {

/// Eight sums side by side, added up in a fixed order: vector units work on all at once.
template <class Term>
double sum_of(std::size_t count, Term&& term) {
    std::array<double, 8> sums{};
    std::size_t j = 0;
    for (; j + 8 <= count; j += 8) {
        for (std::size_t lane = 0; lane < 8; ++lane) sums[lane] += term(j + lane);
    }
    for (std::size_t lane = 0; j < count; ++j, ++lane) sums[lane] += term(j);
    return ((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]));
}

}  // namespace hanei
