/// Which effects are left out: the most time for the least light, within the tolerance.
#pragma once

#include "engine/plan/light_ceiling.h"
#include "engine/plan/settings.h"

#include <limits>
#include <memory>
#include <vector>

namespace hanei {

/// One thing that may be left out.
struct SkipCandidate {
    LeavingLight missing;
    double saved_ms = 0.0;
    EffectChoice choice = EffectChoice::by_bound;
};

/// Bounds at the places that count, and the choice.
class Skipping {
public:
    /// Places are the calculation points while they are few, the rectangles of grids when they are many,
    /// the scene's surfaces when there is nothing to calculate.
    Skipping(const Scene& scene, std::shared_ptr<const LightCeiling> ceiling);

    /// lx at every place, at most.
    std::vector<double> bounds_of(const LeavingLight& missing) const;

    struct Chosen {
        std::vector<bool> skipped;  ///< one a candidate
        LeavingLight missing;       ///< of all that is skipped
        std::vector<double> bound;  ///< lx a place, of all that is skipped
    };
    /// What must be skipped is; the rest by bound over time saved while the sum stays within the tolerance.
    Chosen choose(std::span<const SkipCandidate> candidates, double tolerance_lux) const;

    bool are_points() const { return are_points_; }  ///< places are the calculation points, in their order

private:
    std::shared_ptr<const LightCeiling> ceiling_;
    std::vector<SeenCells> places_;
    bool are_points_ = false;
};

double greatest(std::span<const double> values);  ///< 0 of none

}  // namespace hanei
