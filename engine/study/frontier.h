/// Which of several ways to an answer are worth taking: none is both cheaper and more exact.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace hanei {

struct CostAndError {
    double cost = 0.0;   ///< time, say
    double error = 0.0;  ///< in any unit, 0 or more
};

/// The Pareto frontier: those that no other beats, by being as cheap and more exact or as exact and
/// cheaper. Errors below `floor` cannot be told apart and count as the floor; of costs closer than `alike`
/// (a share) to the cheapest of them only the most exact is taken.
///
/// Returns   indices, from the cheapest to the most exact, costs rising and errors falling. Of equals the
///           first. What has a figure that is no number, or is below 0, is never among them.
/// Cost      a sort.
std::vector<std::size_t> pareto_frontier(std::span<const CostAndError> ways, double floor = 0.0, double alike = 0.0);

}  // namespace hanei
