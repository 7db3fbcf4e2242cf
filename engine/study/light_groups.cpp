#include "engine/study/light_groups.h"

#include "engine/scene/dimmers.h"

#include <algorithm>
#include <map>

namespace hanei {

namespace {

/// Each group is a solution to keep and to mix: more than this cost more than they save.
constexpr std::size_t most_single_luminaires = 8;

LightGroup group_of(const Scene& scene, const std::vector<const Luminaire*>& luminaires) {
    LightGroup group;
    double brightest = 0.0;
    for (const Luminaire* luminaire : luminaires) brightest = std::max(brightest, luminaire->dimming);
    for (const Luminaire* luminaire : luminaires)
        group.members.push_back({luminaire, brightest > 0.0 ? luminaire->dimming / brightest : 1.0});
    group.level = brightest * group_dimming_of(scene, *luminaires.front()) * scene.maintenance_factor;
    return group;
}

}  // namespace

std::vector<LightGroup> light_groups(const Scene& scene) {
    std::map<ObjectId, std::vector<const Luminaire*>> named;
    std::vector<const Luminaire*> single;
    for (const Luminaire& luminaire : scene.luminaires) {
        if (luminaire.group)
            named[luminaire.group].push_back(&luminaire);
        else
            single.push_back(&luminaire);
    }
    std::vector<LightGroup> groups;
    for (const auto& [id, members] : named) groups.push_back(group_of(scene, members));
    if (single.size() > most_single_luminaires) {
        groups.push_back(group_of(scene, single));
    } else {
        for (const Luminaire* luminaire : single) groups.push_back(group_of(scene, {luminaire}));
    }
    groups.push_back({});
    return groups;
}

}  // namespace hanei
