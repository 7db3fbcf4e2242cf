/// Which effects a scene calls for, and what leaving the others out may cost in lux.
#pragma once

#include "engine/plan/settings.h"
#include "engine/scene/scene.h"

#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace hanei {

struct MissingLight;  // light_ceiling.h

enum class Effect {
    occlusion_direct,   ///< shadow tests between luminaires and points
    penumbra,           ///< soft shadow edges of openings with extent
    interreflection,    ///< light between surfaces at all
    occlusion_patches,  ///< shadow tests between surfaces
    bounces,            ///< how many interreflections
    opening_size,       ///< measured luminaires shine from their openings, not from points
    three_bands,        ///< light in three bands of colour, not in one
    furniture,          ///< light that furniture reflects, every piece by itself
    closure,            ///< light that patches lose or gain is made up for
    daylight,           ///< light of the sky
};

enum class EffectState { simulated, skipped, not_present };

/// How many times wider the patches of surfaces that pass no light on may be.
inline constexpr double wider_when_black = 4.0;

/// A piece of furniture as a reflector.
struct PlannedPiece {
    ObjectId object;
    std::string name;
    EffectState state = EffectState::simulated;
    double bound_lux = 0.0;                    ///< lx that its reflected light adds at any calculation point at most
    double reflectance = 0.0;                  ///< the greatest of its faces: with its area what the paper decides by
    double area = 0.0;                         ///< m2
    double predicted_ms = 0.0;                 ///< what skipping it saves
    std::vector<double> bound_at_points = {};  ///< as of the row
    bool operator==(const PlannedPiece&) const = default;
};

/// One row of the plan.
struct PlannedEffect {
    Effect effect = Effect::interreflection;
    EffectState state = EffectState::simulated;
    std::string why;  ///< one sentence with the figures it rests on
    /// lx that skipping changes at most, or would (of what is always simulated: leaving it out; of
    /// direct shadows, penumbra and openings as far as light comes straight from luminaires), at any calculation
    /// point (at any surface when there is none); 0 when not present, infinite when it has no bound, negative when it
    /// was not asked for. Of bounces cut off by the settings: what those after the last add at most (the iteration part
    /// of error bars says how much it is, so it is not among the skipped).
    double bound_lux = 0.0;
    double predicted_ms = 0.0;              ///< cost if simulated; filled from a cost model
    double measured_ms = -1.0;              ///< filled after the study; negative while unknown
    int count = 0;                          ///< bounces: how many are needed for the accuracy, a priori
    bool may_be_skipped = false;            ///< settings have a choice for it
    std::vector<PlannedPiece> pieces = {};  ///< of furniture
    /// lx at each calculation point, points first and then grids, row by row; empty when they are many. Of
    /// furniture: what all skipped pieces leave out; when none is skipped, any single one.
    std::vector<double> bound_at_points = {};
    bool operator==(const PlannedEffect&) const = default;
};

struct EffectsPlan {
    std::vector<PlannedEffect> effects;                            ///< in the order of Effect
    std::vector<ObjectId> black;                                   ///< furniture whose reflected light is skipped
    std::shared_ptr<const MissingLight> missing = {};              ///< by all that is skipped; null when nothing is
    double skipped_lux = 0.0;                                      ///< lx at any calculation point, at most
    double skipped_anywhere_lux = 0.0;                             ///< lx on any surface, at most
    double uniform_lux = std::numeric_limits<double>::infinity();  ///< lx that all of it adds anywhere, at most

    bool operator==(const EffectsPlan& other) const { return effects == other.effects; }
    const PlannedEffect& row(Effect effect) const;
    bool simulates(Effect effect) const { return row(effect).state == EffectState::simulated; }
    double skipped_at(const Vec3& position, const Vec3& normal) const;  ///< lx there, at most
};

enum class PlanDetail {
    decisions,  ///< bounds only where one is needed to decide: in microseconds
    bounds,     ///< of everything that might be skipped: some ten milliseconds
};

/// Decides from the scene alone, before anything is computed, and the same at both details. What is
/// skipped is taken by the least bound for the time it saves, while the bounds of all of it add up to no more than
/// the tolerance at every calculation point. After it nothing reads settings but method, patch width,
/// bounces and accuracy.
EffectsPlan plan_effects(const Scene& scene, const Settings& settings, PlanDetail detail = PlanDetail::bounds);

/// The setting that decides about an effect; null when none does.
const EffectOption* option_of(Effect effect);

std::string_view name_of(Effect effect);      ///< "direct shadows", ... as every door shows it
std::string_view name_of(EffectState state);  ///< "simulated", "skipped", "not present"

}  // namespace hanei
