#include "engine/transport/flat_loop.h"

namespace hanei {

namespace {

/// Where the line crosses the side that begins at corner k and ends at `next`.
void add_crossing(const FlatLoop& loop, std::size_t k, std::size_t next, double here, double there, FlatLoop& to) {
    const double share = here / (here - there);
    to.add(loop.u[k] + share * (loop.u[next] - loop.u[k]), loop.v[k] + share * (loop.v[next] - loop.v[k]));
}

}  // namespace

void split(const FlatLoop& loop, const FlatLine& line, FlatLoop& inside, FlatLoop& outside) {
    inside.count = outside.count = 0;
    std::array<double, FlatLoop::most> heights;
    for (std::size_t k = 0; k < loop.count; ++k) heights[k] = line.height(loop.u[k], loop.v[k]);
    for (std::size_t k = 0; k < loop.count; ++k) {
        const std::size_t next = k + 1 < loop.count ? k + 1 : 0;
        const double here = heights[k], there = heights[next];
        if (here <= 0.0) inside.add(loop.u[k], loop.v[k]);
        if (here >= 0.0) outside.add(loop.u[k], loop.v[k]);
        if ((here > 0.0 && there < 0.0) || (here < 0.0 && there > 0.0)) {
            add_crossing(loop, k, next, here, there, inside);
            add_crossing(loop, k, next, here, there, outside);
        }
    }
}

void clip(FlatLoop& loop, const FlatLine& line) {
    std::array<double, FlatLoop::most> heights;
    bool any_outside = false;
    for (std::size_t k = 0; k < loop.count; ++k) {
        heights[k] = line.height(loop.u[k], loop.v[k]);
        any_outside = any_outside || heights[k] > 0.0;
    }
    if (!any_outside) return;
    FlatLoop kept;
    for (std::size_t k = 0; k < loop.count; ++k) {
        const std::size_t next = k + 1 < loop.count ? k + 1 : 0;
        const double here = heights[k], there = heights[next];
        if (here <= 0.0) kept.add(loop.u[k], loop.v[k]);
        if ((here > 0.0 && there < 0.0) || (here < 0.0 && there > 0.0)) add_crossing(loop, k, next, here, there, kept);
    }
    loop = kept;
}

}  // namespace hanei
