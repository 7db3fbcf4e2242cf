#include "ui/panels/selection.h"

#include "engine/edit/edit.h"

#include <algorithm>

namespace hanei {

bool Selection::holds(ObjectId id) const { return std::find(ids_.begin(), ids_.end(), id) != ids_.end(); }

void Selection::choose(ObjectId id) {
    ids_.clear();
    add(id);
}

void Selection::add(ObjectId id) {
    if (!id) return;
    std::erase(ids_, id);
    ids_.push_back(id);
}

void Selection::toggle(ObjectId id) {
    if (holds(id))
        std::erase(ids_, id);
    else
        add(id);
}

void Selection::keep_existing(const Scene& scene) {
    std::erase_if(ids_, [&](ObjectId id) { return kind_of(scene, id) == ObjectKind::none; });
}

}  // namespace hanei
