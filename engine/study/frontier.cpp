#include "engine/study/frontier.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hanei {

std::vector<std::size_t> pareto_frontier(std::span<const CostAndError> ways, double floor, double alike) {
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < ways.size(); ++k) {
        const CostAndError& way = ways[k];
        if (std::isfinite(way.cost) && std::isfinite(way.error) && way.cost >= 0.0 && way.error >= 0.0)
            order.push_back(k);
    }
    const auto error_of = [&](std::size_t k) { return std::max(ways[k].error, floor); };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return ways[a].cost != ways[b].cost ? ways[a].cost < ways[b].cost : error_of(a) < error_of(b);
    });
    std::vector<std::size_t> frontier;
    double least = std::numeric_limits<double>::infinity(), cheapest = 0.0;  // of those alike
    for (const std::size_t k : order) {
        if (error_of(k) >= least) continue;
        least = error_of(k);
        const bool is_alike = !frontier.empty() && ways[k].cost <= (1.0 + alike) * cheapest;
        if (is_alike) {
            frontier.back() = k;
        } else {
            frontier.push_back(k);
            cheapest = ways[k].cost;
        }
    }
    return frontier;
}

}  // namespace hanei
