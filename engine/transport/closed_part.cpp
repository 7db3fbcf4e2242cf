#include "engine/transport/closed_part.h"

#include "engine/base/check.h"

#include <algorithm>

namespace hanei {

namespace {

// Of the light of an unknown, and of what it sees: less is the rounding of stored factors.
constexpr double least_share = 1e-6;

using Members = std::vector<double>;  // 1 or 0 an unknown: what is sent through the rows

bool product(const Exchange& exchange, const Members& leaving, std::vector<double>& arriving, const Work& work) {
    arriving.resize(leaving.size());
    return !work.stop.stop_requested() && exchange(leaving, arriving, 1);
}

/// Adds the `candidates` that see members, and those that see these. False when stopped.
bool spread(const Exchange& exchange, const Members& candidates, Members& members, const Work& work) {
    std::vector<double> seen;
    for (bool more = true; more;) {
        if (!product(exchange, members, seen, work)) return false;
        more = false;
        for (std::size_t k = 0; k < members.size(); ++k) {
            if (members[k] > 0.0 || candidates[k] == 0.0 || seen[k] <= least_share) continue;
            members[k] = 1.0;
            more = true;
        }
    }
    return true;
}

}  // namespace

std::optional<std::vector<std::size_t>> closed_unknowns(const Exchange& exchange, std::span<const double> reflectance,
                                                        std::span<const double> emitted, const Work& work,
                                                        double row_error) {
    HANEI_CHECK(reflectance.size() == emitted.size());
    const auto reflects_all = [](double value) { return value >= 1.0 - least_share; };
    if (std::none_of(reflectance.begin(), reflectance.end(), reflects_all)) return std::vector<std::size_t>{};

    const std::size_t count = reflectance.size();
    std::vector<double> row_sums;
    if (!product(exchange, Members(count, 1.0), row_sums, work)) return std::nullopt;
    Members losing(count, 0.0);
    for (std::size_t k = 0; k < count; ++k) {
        const double escapes = std::max(0.0, 1.0 - row_sums[k] - row_error);
        losing[k] = 1.0 - reflectance[k] * (1.0 - escapes) > least_share ? 1.0 : 0.0;
    }
    if (!spread(exchange, Members(count, 1.0), losing, work)) return std::nullopt;

    Members keeping(count, 0.0), lit(count, 0.0);
    for (std::size_t k = 0; k < count; ++k) {
        keeping[k] = 1.0 - losing[k];
        lit[k] = keeping[k] > 0.0 && emitted[k] > 0.0 ? 1.0 : 0.0;
    }
    if (std::find(lit.begin(), lit.end(), 1.0) == lit.end()) return std::vector<std::size_t>{};
    if (!spread(exchange, keeping, lit, work)) return std::nullopt;
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < count; ++k) {
        if (lit[k] > 0.0) found.push_back(k);
    }
    return found;
}

}  // namespace hanei
