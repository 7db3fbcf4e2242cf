/// What each effect really adds and takes in this scene: the same study with and without it.
#pragma once

#include "engine/base/progress.h"
#include "engine/plan/plan.h"

#include <functional>
#include <optional>
#include <vector>

namespace hanei {

struct EffectTrial {
    std::optional<Effect> effect;  ///< what is left out; none: all that the plan skips
    double without_ms = 0.0;       ///< from nothing to every value
    double saved_ms = 0.0;         ///< everything's time less that; within the machine's noise it may be negative
    double change_lux = 0.0;       ///< the greatest at any calculation point
    double mean_change_lux = 0.0;
    Vec3 position{0.0};       ///< m, of the greatest change
    double bound_lux = -1.0;  ///< what the plan says of it in advance; negative where it says nothing
    bool operator==(const EffectTrial&) const = default;
};

struct EffectTrials {
    double everything_ms = 0.0;  ///< with all effects, nothing skipped
    std::size_t places = 0;      ///< calculation points that were compared
    std::vector<EffectTrial> trials;
    const EffectTrial* of(std::optional<Effect> effect) const;  ///< null when it was not tried
};

/// Tried are the effects that settings may leave out, shadows between surfaces (not by the method linear, whose
/// refinement would be counted too) and the size of measured openings, where the scene has them; last what
/// the plan skips by these settings, if anything.
///
/// Needs     a scene without errors.
/// Returns   empty when stopped.
/// Cost      each study three times while short, once when it takes more than two seconds.
std::optional<EffectTrials> try_effects(const SceneSnapshot& scene, const Settings& settings, const Work& work);

}  // namespace hanei
