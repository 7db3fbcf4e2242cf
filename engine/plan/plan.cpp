#include "engine/plan/plan.h"

#include "engine/plan/colour_reason.h"
#include "engine/plan/cost_model.h"
#include "engine/plan/direct_changes.h"
#include "engine/plan/light_bounds.h"
#include "engine/plan/measured_openings.h"
#include "engine/plan/places.h"
#include "engine/plan/planned_pieces.h"
#include "engine/plan/skipping.h"

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

constexpr double not_asked = -1.0;

/// Decides row by row; every member may rest on those before.
class Planner {
public:
    Planner(const Scene& scene, const Settings& settings, PlanDetail detail)
        : scene_(scene),
          settings_(settings),
          faces_(faces_of(scene)),
          obstacles_(obstacles_of(scene)),
          light_(light_bounds(scene, faces_)),
          cost_(cost_model(scene, settings, faces_)) {
        const bool decides = settings.tolerance_lux > 0.0 || any_is(EffectChoice::never);
        if (!light_.is_dark() && (decides || detail == PlanDetail::bounds)) {
            ceiling_ = std::make_shared<const LightCeiling>(scene, faces_);
            skipping_.emplace(scene, ceiling_);
        }
        if (detail == PlanDetail::bounds) points_ = few_calculation_points(scene);
        if (!points_.empty()) changes_ = direct_changes(scene, points_);
    }

    EffectsPlan plan() {
        EffectsPlan plan;
        const PlannedEffect between = interreflection(plan);
        const PlannedEffect bands = colour(between.state), pieces = furniture(between.state);
        plan.effects = {direct_shadows(), penumbra(), between, patch_shadows(between), bounces(between.state),
                        opening_size(),   bands,      pieces,  closure(between.state), daylight()};
        if (between.state == EffectState::simulated) skip_parts(plan);
        return plan;
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
        PlannedEffect made = row(effect, EffectState::simulated, "Light may be blocked by " + obstacles_ + ".",
                                 cost_.direct_occlusion_ms());
        bound_at_points(made, changes_.shadows);
        return made;
    }

    PlannedEffect penumbra() const {
        constexpr Effect effect = Effect::penumbra;
        if (light_.luminaires == 0) return absent(effect, "No luminaire gives light.");
        if (light_.luminaires_with_extent == 0) {
            return absent(effect, "All luminaires that give light are points: their shadows have hard edges.");
        }
        if (obstacles_.empty()) return absent(effect, "There are no shadows, hence no soft edges of shadows.");
        PlannedEffect made =
            row(effect, EffectState::simulated,
                std::to_string(light_.luminaires_with_extent) + " of " + std::to_string(light_.luminaires) +
                    " luminaires have extent and may be partly hidden.",
                0.5 * cost_.direct_occlusion_ms());
        bound_at_points(made, changes_.penumbra);
        return made;
    }

    /// Of what is always simulated: by how much less of it would change the values.
    void bound_at_points(PlannedEffect& made, std::span<const double> bounds) const {
        if (points_.empty()) return;
        made.bound_lux = greatest(bounds);
        made.bound_at_points.assign(bounds.begin(), bounds.end());
    }

    bool any_is(EffectChoice choice) const {
        return std::any_of(effect_options.begin(), effect_options.end(),
                           [&](const EffectOption& option) { return settings_.*option.member == choice; });
    }
    /// Of a row or a piece.
    template <class Planned>
    void take_bounds(Planned& planned, std::vector<double> bounds) const {
        planned.bound_lux = greatest(bounds);
        if (skipping_->are_points()) planned.bound_at_points = std::move(bounds);
    }
    void leave_out(EffectsPlan& plan, LeavingLight missing, std::span<const double> bounds) const {
        plan.missing = std::make_shared<const MissingLight>(MissingLight{ceiling_, std::move(missing)});
        plan.skipped_lux = std::min(plan.uniform_lux, greatest(bounds));
        plan.skipped_anywhere_lux = std::min(plan.uniform_lux, std::max(plan.skipped_lux, plan.missing->anywhere()));
    }
    static std::string who(EffectChoice choice) {
        return choice == EffectChoice::always ? " You asked for it always." : std::string();
    }
    std::string within() const { return "within the tolerance of " + figure(settings_.tolerance_lux) + " lx"; }

    PlannedEffect interreflection(EffectsPlan& plan) const {
        constexpr Effect effect = Effect::interreflection;
        if (faces_.empty()) return absent(effect, "There are no surfaces.");
        if (light_.is_dark()) return absent(effect, "Nothing in the scene gives light.");
        if (light_.reflectance <= 0.0 && light_.own_exitance <= 0.0) {
            return absent(effect, "Every surface has reflectance 0.");
        }
        const std::string rests_on =
            (std::isfinite(light_.direct) ? "at most " + figure(light_.direct) + " lx of direct light on any surface"
                                          : std::string("direct light that has no bound where a luminaire touches")) +
            (light_.own_exitance > 0.0 ? ", " + figure(light_.own_exitance) + " lm/m2 emitted by surfaces"
                                       : std::string()) +
            " and a greatest reflectance of " + figure(light_.reflectance);
        PlannedEffect made =
            row(effect, EffectState::simulated, "", cost_.factors_ms() + cost_.bounces_ms(bounces_needed()));
        made.may_be_skipped = true;
        made.bound_lux = light_.interreflected_after(0);
        if (skipping_) {
            const SkipCandidate all{ceiling_->leaving(), made.predicted_ms, settings_.interreflection};
            const std::vector<double> bounds = skipping_->bounds_of(all.missing);
            const bool anywhere = made.bound_lux <= settings_.tolerance_lux;  // whatever the ceiling says
            take_bounds(made, bounds);
            const double uniform = light_.interreflected_after(0);
            made.bound_lux = std::min(made.bound_lux, uniform);
            for (double& lux : made.bound_at_points) lux = std::min(lux, uniform);
            const auto chosen = skipping_->choose(std::span(&all, 1), settings_.tolerance_lux);
            if (chosen.skipped[0] ||
                (anywhere && all.choice == EffectChoice::by_bound && settings_.tolerance_lux > 0.0)) {
                made.state = EffectState::skipped;
                plan.uniform_lux = uniform;
                leave_out(plan, all.missing, bounds);
                made.why = "It adds at most " + figure(made.bound_lux) + " lx " + where() + " (" + rests_on + "), " +
                           (all.choice == EffectChoice::never ? "and you asked to leave it out." : within() + ".");
                return made;
            }
        }
        made.why = (std::isfinite(made.bound_lux) ? "It may add up to " + figure(made.bound_lux) + " lx"
                                                  : std::string("What it may add has no bound in advance")) +
                   " (" + rests_on + ")." + who(settings_.interreflection);
        return made;
    }

    /// Of what bounds are of.
    std::string where() const {
        return scene_.points.empty() && scene_.grids.empty() ? "on any surface" : "at any calculation point";
    }

    /// With them or without, interreflection adds no more than its bound.
    PlannedEffect patch_shadows(const PlannedEffect& between) const {
        constexpr Effect effect = Effect::occlusion_patches;
        if (between.state != EffectState::simulated) return absent(effect, "Light between surfaces is not simulated.");
        if (obstacles_.empty()) return absent(effect, unobstructed);
        PlannedEffect made =
            row(effect, EffectState::simulated, "Sight between surfaces may be blocked by " + obstacles_ + ".",
                cost_.patch_occlusion_ms());
        bound_at_points(made, between.bound_at_points);
        return made;
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
        PlannedEffect made = row(Effect::opening_size, EffectState::simulated, openings.why, cost_.direct_ms());
        bound_at_points(made, changes_.openings);
        return made;
    }

    PlannedEffect colour(EffectState between) {
        const ColourReason reason = colour_reason(scene_);
        if (!reason.coloured) return absent(Effect::three_bands, reason.why);
        // Of the three bands' products the first is that of interreflection itself.
        PlannedEffect made = row(Effect::three_bands, EffectState::simulated, reason.why,
                                 between == EffectState::simulated ? 2.0 * cost_.bounces_ms(bounces_needed()) : 0.0);
        made.may_be_skipped = between == EffectState::simulated;
        made.bound_lux = not_asked;
        if (made.may_be_skipped && skipping_) {
            colour_light_ = ceiling_->without_colour();
            take_bounds(made, skipping_->bounds_of(colour_light_));
        }
        made.why += who(settings_.colour);
        return made;
    }

    /// Every piece, its bound when it was asked for.
    PlannedEffect furniture(EffectState between) {
        constexpr Effect effect = Effect::furniture;
        if (scene_.furniture.empty()) return absent(effect, "There is no furniture.");
        if (between != EffectState::simulated) return absent(effect, "Light between surfaces is not simulated.");
        PlannedEffect made = row(effect, EffectState::simulated, "", 0.0);
        made.may_be_skipped = true;
        made.bound_lux = skipping_ ? 0.0 : not_asked;
        made.pieces = planned_pieces(scene_, faces_, cost_);
        for (PlannedPiece& piece : made.pieces) {
            made.predicted_ms += piece.predicted_ms;
            piece.bound_lux = not_asked;
            if (!skipping_) continue;
            piece_light_.push_back(ceiling_->without_reflection_of(piece.object));
            take_bounds(piece, skipping_->bounds_of(piece_light_.back()));
            made.bound_lux = std::max(made.bound_lux, piece.bound_lux);
            made.bound_at_points.resize(piece.bound_at_points.size(), 0.0);
            for (std::size_t k = 0; k < piece.bound_at_points.size(); ++k)
                made.bound_at_points[k] = std::max(made.bound_at_points[k], piece.bound_at_points[k]);
        }
        return made;
    }

    /// Colour and single pieces of furniture, once interreflection is simulated.
    void skip_parts(EffectsPlan& plan) const {
        PlannedEffect& bands = row_of(plan, Effect::three_bands);
        PlannedEffect& pieces = row_of(plan, Effect::furniture);
        std::vector<SkipCandidate> candidates;
        const bool coloured = bands.state == EffectState::simulated;
        if (skipping_) {
            if (coloured) candidates.push_back({colour_light_, bands.predicted_ms, settings_.colour});
            for (std::size_t p = 0; p < pieces.pieces.size(); ++p)
                candidates.push_back({piece_light_[p], pieces.pieces[p].predicted_ms, settings_.furniture});
        }
        std::size_t skipped_pieces = 0;
        if (!candidates.empty()) {
            const auto chosen = skipping_->choose(candidates, settings_.tolerance_lux);
            std::size_t k = 0;
            if (coloured && chosen.skipped[k++]) {
                bands.state = EffectState::skipped;
                bands.why += " In one band the photometric figures differ by at most " + figure(bands.bound_lux) +
                             " lx " + where() + ".";
            }
            LeavingLight of_pieces;
            for (PlannedPiece& piece : pieces.pieces) {
                if (!chosen.skipped[k++]) continue;
                piece.state = EffectState::skipped;
                plan.black.push_back(piece.object);
                ++skipped_pieces;
                of_pieces += candidates[k - 1].missing;
            }
            if (skipped_pieces > 0) take_bounds(pieces, skipping_->bounds_of(of_pieces));
            if (skipped_pieces > 0 || bands.state == EffectState::skipped)
                leave_out(plan, chosen.missing, chosen.bound);
        }
        if (pieces.pieces.empty()) return;
        if (skipped_pieces == pieces.pieces.size()) pieces.state = EffectState::skipped;
        const std::size_t kept = pieces.pieces.size() - skipped_pieces;
        if (skipped_pieces == 0) {
            pieces.why = pieces.bound_lux < 0.0
                             ? "Every piece reflects light."
                             : "What a piece reflects may add up to " +
                                   (std::isfinite(pieces.bound_lux) ? figure(pieces.bound_lux) + " lx"
                                                                    : std::string("any light")) +
                                   " " + where() + ".";
        } else {
            pieces.why = std::to_string(skipped_pieces) + " of " + std::to_string(pieces.pieces.size()) +
                         " pieces are taken as black: together they add at most " + figure(pieces.bound_lux) + " lx " +
                         where() + (kept > 0 ? "; the others reflect." : ".");
        }
        pieces.why += who(settings_.furniture);
    }

    PlannedEffect closure(EffectState between) const {
        constexpr Effect effect = Effect::closure;
        if (between != EffectState::simulated) return absent(effect, "Light between surfaces is not simulated.");
        if (settings_.method == Method::paper)
            return absent(effect, "The paper's method leaves what its form factors lose or gain as it is.");
        return row(effect, EffectState::simulated,
                   "What patches lose or gain of the light between them is made up for; error bars say how far it "
                   "may be misplaced.",
                   cost_.bounces_ms(0));
    }

    PlannedEffect daylight() const {
        return absent(Effect::daylight, "The scene has no sky: windows are surfaces like others.");
    }

    static PlannedEffect& row_of(EffectsPlan& plan, Effect effect) {
        return plan.effects[static_cast<std::size_t>(effect)];
    }

    static constexpr const char* unobstructed =
        "Nothing can stand in the way: no furniture, and everything lies on the front of every surface.";

    const Scene& scene_;
    Settings settings_;
    std::vector<Face> faces_;
    std::string obstacles_;
    LightBounds light_;
    CostModel cost_;
    std::shared_ptr<const LightCeiling> ceiling_;
    std::optional<Skipping> skipping_;
    std::vector<Receiver> points_;  ///< that bounds are told at
    DirectChanges changes_;
    LeavingLight colour_light_;              ///< that one band may leave out
    std::vector<LeavingLight> piece_light_;  ///< that each piece reflects
};

}  // namespace

EffectsPlan plan_effects(const Scene& scene, const Settings& settings, PlanDetail detail) {
    return Planner(scene, settings, detail).plan();
}

}  // namespace hanei
