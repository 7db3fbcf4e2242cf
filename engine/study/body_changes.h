/// What came, went or moved between two sets of shadow casters.
#pragma once

#include "engine/geometry/occluders.h"

#include <memory>

namespace hanei {

/// A body that moved is in both.
struct BodyChanges {
    OccluderSet gone, come;
    /// More than half of the bodies: asking what each touched costs more than it saves.
    bool most = false;
};
BodyChanges body_changes(const OccluderSet& was, const OccluderSet& is);

/// The same, kept for the next who asks about the same two sets.
class LastBodyChanges {
public:
    const BodyChanges& between(const std::shared_ptr<const OccluderSet>& was,
                               const std::shared_ptr<const OccluderSet>& is);

private:
    std::shared_ptr<const OccluderSet> was_, is_;
    BodyChanges changes_;
};

}  // namespace hanei
