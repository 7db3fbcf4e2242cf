/// Luminaires that are dimmed together: their light is solved once and mixed as the dimmers say.
#pragma once

#include "engine/scene/scene.h"

#include <vector>

namespace hanei {

struct LightGroup {
    struct Member {
        const Luminaire* luminaire = nullptr;
        double share = 1.0;  ///< of the group's level: 1 for the brightest
    };
    std::vector<Member> members;  ///< none: the surfaces that emit by themselves
    double level = 1.0;           ///< greatest own dimming of a member, times the group's and the maintenance factor
};

/// Every named group, every luminaire without a group (all these together when they are many), and
/// last the surfaces that emit by themselves. Dimming a whole group changes its level only.
///
/// Needs     the scene to outlive the groups.
std::vector<LightGroup> light_groups(const Scene& scene);

}  // namespace hanei
