/// Which effects a scene calls for, and what leaving the others out may cost in lux.
#pragma once

#include "engine/plan/settings.h"
#include "engine/scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace hanei {

enum class Effect {
    occlusion_direct,   ///< shadow tests between luminaires and points
    penumbra,           ///< soft shadow edges of openings with extent
    interreflection,    ///< light between surfaces at all
    occlusion_patches,  ///< shadow tests between surfaces
    bounces,            ///< how many interreflections
    opening_size,       ///< measured luminaires shine from their openings, not from points
    three_bands,        ///< light in three bands of colour, not in one
};

enum class EffectState { simulated, skipped, not_present };

/// One row of the plan.
struct PlannedEffect {
    Effect effect = Effect::interreflection;
    EffectState state = EffectState::simulated;
    std::string why;  ///< one sentence with the figures it rests on
    /// lx at any point that skipping leaves out at most; 0 when simulated or not present. Of bounces
    /// cut off by the settings: what those after the last add at most (the iteration part of error
    /// bars says how much it is, so it is not among the skipped).
    double bound_lux = 0.0;
    double predicted_ms = 0.0;  ///< cost if simulated; filled from a cost model
    double measured_ms = -1.0;  ///< filled after the study; negative while unknown
    int count = 0;              ///< bounces: how many are needed for the accuracy, a priori
    bool operator==(const PlannedEffect&) const = default;
};

struct EffectsPlan {
    std::vector<PlannedEffect> effects;  ///< in the order of Effect
    bool operator==(const EffectsPlan&) const = default;

    const PlannedEffect& row(Effect effect) const;
    bool simulates(Effect effect) const { return row(effect).state == EffectState::simulated; }
    double skipped_bound_lux() const;  ///< sum of the bounds of all skipped effects
};

/// Decides from the scene alone, before anything is computed. After it nothing reads settings but
/// method, patch width, bounces and accuracy.
EffectsPlan plan_effects(const Scene& scene, const Settings& settings);

std::string_view name_of(Effect effect);      ///< "direct shadows", ... as every door shows it
std::string_view name_of(EffectState state);  ///< "simulated", "skipped", "not present"

}  // namespace hanei
