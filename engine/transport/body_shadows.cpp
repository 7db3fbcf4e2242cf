#include "engine/transport/body_shadows.h"

namespace hanei {

void BodyShadows::start(std::span<const Receiver> side_by_side) {
    receivers_.assign(side_by_side.begin(), side_by_side.end());
    ++number_;
    const std::size_t count = side_by_side.size() * occluders_.bodies().size();
    if (known_.size() < count) known_.resize(count);
}

const BodyShadows::Shadow& BodyShadows::of(std::size_t receiver, BodyIndex body) {
    Shadow& shadow = known_[receiver * occluders_.bodies().size() + body];
    if (shadow.made_for != number_) {
        const Receiver& from = receivers_[receiver];
        shadow.hides =
            hidden_region(occluders_.shape(body), from.position, from.inward, occluders_.same_place(), shadow.planes);
        shadow.made_for = number_;
    }
    return shadow;
}

}  // namespace hanei
