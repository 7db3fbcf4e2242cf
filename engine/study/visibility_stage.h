/// Visibility between receivers and patches, kept while bodies stand still and brought up to date
/// where one moved.
#pragma once

#include "engine/transport/factors.h"

#include <memory>
#include <optional>
#include <span>

namespace hanei {

class VisibilityStage {
public:
    /// What the kept rows belong to: objects that are the same as long as mesh and receivers are.
    struct Rows {
        std::shared_ptr<const void> geometry;
        std::shared_ptr<const void> receivers;
        bool operator==(const Rows&) const = default;
    };

    /// `occluders` may be null: everything is visible.
    /// Returns   null when stopped.
    const Visibility* get(const Rows& rows, const Mesh& mesh, std::span<const Receiver> receivers,
                          const std::shared_ptr<const OccluderSet>& occluders, const Work& work);

    bool reused() const { return reused_; }  ///< the last get() worked nothing out

private:
    Rows rows_;
    std::shared_ptr<const OccluderSet> occluders_;
    std::optional<Visibility> value_;
    bool reused_ = false;
};

}  // namespace hanei
