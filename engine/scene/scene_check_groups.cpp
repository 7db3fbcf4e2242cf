#include "engine/scene/scene_findings.h"

#include <set>

namespace hanei {

/// Members exist, and each is in one group only.
void check_groups(SceneChecks& checks) {
    std::set<ObjectId> known, taken;
    const auto note = [&](const auto& list) {
        for (const auto& object : list) known.insert(object.id);
    };
    note(checks.scene.furniture);
    note(checks.scene.surfaces);
    note(checks.scene.luminaires);
    note(checks.scene.grids);
    note(checks.scene.points);
    const std::vector<ObjectGroup>& groups = checks.scene.object_groups;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        ObjectFindings object = checks.about("object_groups", i, "group", groups[i].name, groups[i].id);
        checks.check_id(object, groups[i].id);
        if (groups[i].members.empty()) object.warn("members", "it has no members; dissolve it");
        for (std::size_t k = 0; k < groups[i].members.size(); ++k) {
            const ObjectId member = groups[i].members[k];
            const std::string field = "members[" + std::to_string(k) + ']';
            if (known.count(member) == 0)
                object.error(field, "there is no such furniture, surface, luminaire, grid or point; name another");
            else if (!taken.insert(member).second)
                object.error(field, "the object is in a group already; it can be in one only");
        }
    }
}

}  // namespace hanei
