#include "engine/plan/plan.h"

#include "engine/base/check.h"
#include "engine/plan/colour_reason.h"
#include "engine/plan/cost_model.h"
#include "engine/plan/light_bounds.h"
#include "engine/plan/measured_openings.h"
#include "engine/plan/places.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace hanei {

namespace {

/// A figure as a sentence shows it.
std::string figure(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

/// Decides row by row; every member may rest on those before.
class Planner {
public:
    Planner(const Scene& scene, const Settings& settings)
        : scene_(scene),
          settings_(settings),
          faces_(faces_of(scene)),
          obstacles_(obstacles_of(scene)),
          light_(light_bounds(scene, faces_)),
          cost_(cost_model(scene, settings, faces_)) {}

    EffectsPlan plan() const {
        const PlannedEffect between = interreflection();
        return {{direct_shadows(), penumbra(), between, patch_shadows(between.state), bounces(between.state),
                 opening_size(), colour(between.state)}};
    }

private:
    static PlannedEffect row(Effect effect, EffectState state, std::string why, double milliseconds) {
        PlannedEffect made;
        made.effect = effect;
        made.state = state;
        made.why = std::move(why);
        made.predicted_ms = milliseconds;
        return made;
    }
    PlannedEffect absent(Effect effect, std::string why) const {
        return row(effect, EffectState::not_present, std::move(why), 0.0);
    }

    PlannedEffect direct_shadows() const {
        constexpr Effect effect = Effect::occlusion_direct;
        if (light_.luminaires == 0) return absent(effect, "No luminaire gives light.");
        if (obstacles_.empty()) return absent(effect, unobstructed);
        return row(effect, EffectState::simulated, "Light may be blocked by " + obstacles_ + ".",
                   cost_.direct_occlusion_ms());
    }

    PlannedEffect penumbra() const {
        constexpr Effect effect = Effect::penumbra;
        if (light_.luminaires == 0) return absent(effect, "No luminaire gives light.");
        if (light_.luminaires_with_extent == 0) {
            return absent(effect, "All luminaires that give light are points: their shadows have hard edges.");
        }
        if (obstacles_.empty()) return absent(effect, "There are no shadows, hence no soft edges of shadows.");
        return row(effect, EffectState::simulated,
                   std::to_string(light_.luminaires_with_extent) + " of " + std::to_string(light_.luminaires) +
                       " luminaires have extent and may be partly hidden.",
                   0.5 * cost_.direct_occlusion_ms());
    }

    PlannedEffect interreflection() const {
        constexpr Effect effect = Effect::interreflection;
        if (faces_.empty()) return absent(effect, "There are no surfaces.");
        if (light_.is_dark()) return absent(effect, "Nothing in the scene gives light.");
        if (light_.reflectance <= 0.0 && light_.own_exitance <= 0.0) {
            return absent(effect, "Every surface has reflectance 0.");
        }
        const double bound = light_.interreflected_after(0);
        const std::string rests_on =
            "at most " + figure(light_.direct) + " lx of direct light on any surface" +
            (light_.own_exitance > 0.0 ? ", " + figure(light_.own_exitance) + " lm/m2 emitted by surfaces"
                                       : std::string()) +
            " and a greatest reflectance of " + figure(light_.reflectance);
        const double milliseconds = cost_.factors_ms() + cost_.bounces_ms(bounces_needed());
        if (bound <= settings_.tolerance_lux) {
            PlannedEffect skipped = row(effect, EffectState::skipped,
                                        "It adds at most " + figure(bound) + " lx anywhere (" + rests_on +
                                            "), within the tolerance of " + figure(settings_.tolerance_lux) + " lx.",
                                        milliseconds);
            skipped.bound_lux = bound;
            return skipped;
        }
        const std::string upper = std::isfinite(bound) ? "It may add up to " + figure(bound) + " lx"
                                                       : "What it may add has no bound in advance";
        return row(effect, EffectState::simulated, upper + " (" + rests_on + ").", milliseconds);
    }

    PlannedEffect patch_shadows(EffectState between) const {
        constexpr Effect effect = Effect::occlusion_patches;
        if (between != EffectState::simulated) return absent(effect, "Light between surfaces is not simulated.");
        if (obstacles_.empty()) return absent(effect, unobstructed);
        return row(effect, EffectState::simulated, "Sight between surfaces may be blocked by " + obstacles_ + ".",
                   cost_.patch_occlusion_ms());
    }

    /// With the greatest reflectance r, what comes after K reflections is at most r^K / (1 - r) of
    /// what was first reflected or emitted.
    int bounces_needed() const {
        const double r = light_.reflectance;
        if (r <= 0.0) return 1;
        if (r >= 1.0) return settings_.bounces;
        const double needed = std::log(std::max(settings_.accuracy, 1e-15) * (1.0 - r)) / std::log(r);
        return static_cast<int>(std::clamp(std::ceil(needed), 1.0, 1e6));
    }

    PlannedEffect bounces(EffectState between) const {
        constexpr Effect effect = Effect::bounces;
        if (between != EffectState::simulated) return absent(effect, "Light between surfaces is not simulated.");
        const int needed = bounces_needed();
        const int planned = std::min(needed, settings_.bounces);
        std::string why = "With a greatest reflectance of " + figure(light_.reflectance) + ", " +
                          std::to_string(needed) + " interreflections leave less than " +
                          figure(100.0 * settings_.accuracy) +
                          " % unknown; a closer bracket usually ends them earlier.";
        if (light_.reflectance >= 1.0) {
            why = "A surface of reflectance 1 loses nothing: no number of interreflections is enough in advance.";
        }
        PlannedEffect made = row(effect, EffectState::simulated, std::move(why), cost_.bounces_ms(planned));
        made.count = planned;
        if (planned < needed || light_.reflectance >= 1.0) {
            made.bound_lux = light_.interreflected_after(planned);
            made.why += " Stopping after " + std::to_string(planned) + " leaves out " +
                        (std::isfinite(made.bound_lux) ? "at most " + figure(made.bound_lux) + " lx"
                                                       : std::string("what cannot be bounded in advance")) +
                        "; the error bars say how much it is.";
        }
        return made;
    }

    PlannedEffect opening_size() const {
        const MeasuredOpenings openings = measured_openings(scene_);
        if (openings.luminaires == 0)
            return absent(Effect::opening_size, "No luminaire shines from a measured opening.");
        return row(Effect::opening_size, EffectState::simulated, openings.why, cost_.direct_ms());
    }

    PlannedEffect colour(EffectState between) const {
        const ColourReason reason = colour_reason(scene_);
        if (!reason.coloured) return absent(Effect::three_bands, reason.why);
        // Of the three bands' products the first is that of interreflection itself.
        return row(Effect::three_bands, EffectState::simulated, reason.why,
                   between == EffectState::simulated ? 2.0 * cost_.bounces_ms(bounces_needed()) : 0.0);
    }

    static constexpr const char* unobstructed =
        "Nothing can stand in the way: no furniture, and everything lies on the front of every surface.";

    const Scene& scene_;
    Settings settings_;
    std::vector<Face> faces_;
    std::string obstacles_;
    LightBounds light_;
    CostModel cost_;
};

}  // namespace

const PlannedEffect& EffectsPlan::row(Effect effect) const {
    const auto found = std::find_if(effects.begin(), effects.end(),
                                    [effect](const PlannedEffect& planned) { return planned.effect == effect; });
    HANEI_CHECK(found != effects.end());
    return *found;
}

double EffectsPlan::skipped_bound_lux() const {
    double sum = 0.0;
    for (const PlannedEffect& effect : effects) {
        if (effect.state == EffectState::skipped) sum += effect.bound_lux;
    }
    return sum;
}

EffectsPlan plan_effects(const Scene& scene, const Settings& settings) { return Planner(scene, settings).plan(); }

std::string_view name_of(Effect effect) {
    switch (effect) {
        case Effect::occlusion_direct:
            return "direct shadows";
        case Effect::penumbra:
            return "penumbra";
        case Effect::interreflection:
            return "interreflection";
        case Effect::occlusion_patches:
            return "shadows between surfaces";
        case Effect::bounces:
            return "bounces";
        case Effect::opening_size:
            return "size of openings";
        case Effect::three_bands:
            return "colour bands";
    }
    return "";
}

std::string_view name_of(EffectState state) {
    switch (state) {
        case EffectState::simulated:
            return "simulated";
        case EffectState::skipped:
            return "skipped";
        case EffectState::not_present:
            return "not present";
    }
    return "";
}

}  // namespace hanei
