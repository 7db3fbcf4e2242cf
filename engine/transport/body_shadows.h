/// What bodies hide from receivers, kept while it is asked again.
#pragma once

#include "engine/geometry/configuration_factor.h"
#include "engine/geometry/hidden_region.h"
#include "engine/geometry/occluders.h"

#include <span>
#include <vector>

namespace hanei {

/// Worked out when first asked.
class BodyShadows {
public:
    struct Shadow {
        Hides hides = Hides::nothing;
        std::vector<HalfSpace> planes;
        std::size_t made_for = 0;
    };

    explicit BodyShadows(const OccluderSet& occluders) : occluders_(occluders) {}

    /// Forgets what was known, of the receivers before.
    void start(std::span<const Receiver> side_by_side);
    const Shadow& of(std::size_t receiver, BodyIndex body);

private:
    const OccluderSet& occluders_;
    std::vector<Receiver> receivers_;
    std::size_t number_ = 0;  ///< how many times receivers were given
    std::vector<Shadow> known_;
};

}  // namespace hanei
