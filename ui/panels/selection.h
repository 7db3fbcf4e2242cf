/// The chosen objects, in the order in which they were chosen.
#pragma once

#include "engine/scene/scene.h"

#include <vector>

namespace hanei {

class Selection {
public:
    Selection() = default;
    explicit Selection(ObjectId id) { choose(id); }

    const std::vector<ObjectId>& ids() const { return ids_; }
    bool empty() const { return ids_.empty(); }
    bool holds(ObjectId id) const;

    /// The one chosen last: panels show it, others follow it. The id of nothing when none is chosen.
    ObjectId primary() const { return ids_.empty() ? ObjectId{} : ids_.back(); }

    void choose(ObjectId id);  ///< it alone; the id of nothing: none
    void add(ObjectId id);     ///< it becomes the primary one
    void toggle(ObjectId id);
    void clear() { ids_.clear(); }

    /// Lets go of what the scene no longer holds.
    void keep_existing(const Scene& scene);

    bool operator==(const Selection&) const = default;

private:
    std::vector<ObjectId> ids_;  ///< each once, none of nothing
};

}  // namespace hanei
