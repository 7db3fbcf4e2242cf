#include "ui/panels/choosing.h"

#include "engine/edit/arrangements.h"

#include <algorithm>

namespace hanei {

ObjectId meant_by_click(const Scene& scene, const Selection& before, ObjectId hit, ClickManner manner) {
    const ObjectId group = group_of(scene, hit);
    if (!group) {
        const Arrangement* const arrangement = manner.twice ? arrangement_of(scene, hit) : nullptr;
        return arrangement != nullptr ? arrangement->id : hit;
    }
    const bool entered = group_of(scene, before.primary()) == group;
    return manner.alone || manner.twice || entered ? hit : group;
}

Selection chosen_by_click(const Scene& scene, const Selection& before, ObjectId hit, ClickManner manner) {
    if (!hit) return manner.toggles ? before : Selection();
    const ObjectId meant = meant_by_click(scene, before, hit, manner);
    Selection after = before;
    if (manner.toggles)
        after.toggle(meant);
    else
        after.choose(meant);
    return after;
}

Selection chosen_by_box(const Scene& scene, const Selection& before, const ObjectIds& boxed, BoxManner manner) {
    Selection after = manner == BoxManner::replaces ? Selection() : before;
    for (const ObjectId id : boxed) {
        const ObjectId group = group_of(scene, id);
        const ObjectId meant = group ? group : id;
        if (manner != BoxManner::takes)
            after.add(meant);
        else if (after.holds(meant))
            after.toggle(meant);
    }
    return after;
}

ObjectIds rows_between(const ObjectIds& rows, ObjectId first, ObjectId last) {
    const auto one = std::find(rows.begin(), rows.end(), first);
    const auto other = std::find(rows.begin(), rows.end(), last);
    if (one == rows.end() || other == rows.end()) return {last};
    return one <= other ? ObjectIds(one, other + 1) : ObjectIds(other, one + 1);
}

}  // namespace hanei
