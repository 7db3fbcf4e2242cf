#include "engine/plan/plan.h"

#include "engine/base/check.h"
#include "engine/geometry/polygon.h"
#include "engine/plan/colour_reason.h"
#include "engine/plan/cost_model.h"
#include "engine/plan/light_bounds.h"
#include "engine/plan/measured_openings.h"
#include "engine/plan/places.h"
#include "engine/plan/skipping.h"
#include "engine/scene/colour.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

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
    }

    EffectsPlan plan() {
        EffectsPlan plan;
        const PlannedEffect between = interreflection(plan);
        const PlannedEffect bands = colour(between.state), pieces = furniture(between.state);
        plan.effects = {direct_shadows(), penumbra(), between, patch_shadows(between.state), bounces(between.state),
                        opening_size(),   bands,      pieces,  closure(between.state),       daylight()};
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

    bool any_is(EffectChoice choice) const {
        return std::any_of(effect_options.begin(), effect_options.end(),
                           [&](const EffectOption& option) { return settings_.*option.member == choice; });
    }
    double bound_of(const LeavingLight& missing) const {
        return skipping_ ? greatest(skipping_->bounds_of(missing)) : not_asked;
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
            "at most " + figure(light_.direct) + " lx of direct light on any surface" +
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
            made.bound_lux = std::min(made.bound_lux, greatest(bounds));
            const auto chosen = skipping_->choose(std::span(&all, 1), settings_.tolerance_lux);
            if (chosen.skipped[0] ||
                (anywhere && all.choice == EffectChoice::by_bound && settings_.tolerance_lux > 0.0)) {
                made.state = EffectState::skipped;
                if (skipping_->are_points()) made.bound_at_points = bounds;
                plan.uniform_lux = light_.interreflected_after(0);
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
        PlannedEffect made = row(Effect::three_bands, EffectState::simulated, reason.why,
                                 between == EffectState::simulated ? 2.0 * cost_.bounces_ms(bounces_needed()) : 0.0);
        made.may_be_skipped = between == EffectState::simulated;
        made.bound_lux = not_asked;
        if (made.may_be_skipped && skipping_) made.bound_lux = bound_of(ceiling_->without_colour());
        made.why += who(settings_.colour);
        return made;
    }

    /// Every piece, its bound when it was asked for.
    PlannedEffect furniture(EffectState between) const {
        constexpr Effect effect = Effect::furniture;
        if (scene_.furniture.empty()) return absent(effect, "There is no furniture.");
        if (between != EffectState::simulated) return absent(effect, "Light between surfaces is not simulated.");
        std::map<ObjectId, PlannedPiece> pieces;
        for (const Furniture& each : scene_.furniture) pieces[each.id].name = each.name;
        double all = 0.0;
        for (const Face& face : faces_) {
            const double area = glm::length(vector_area(face.region));
            all += area;
            const auto found = pieces.find(face.ref.object);
            if (found == pieces.end()) continue;
            found->second.area += area;
            found->second.reflectance = std::max(found->second.reflectance, reflectance_of(face));
        }
        PlannedEffect made = row(effect, EffectState::simulated, "", 0.0);
        made.may_be_skipped = true;
        made.bound_lux = skipping_ ? 0.0 : not_asked;
        for (const Furniture& each : scene_.furniture) {
            PlannedPiece piece = pieces[each.id];
            piece.object = each.id;
            // Rows and columns of its patches, all but a few: twice its share of the pairs.
            piece.predicted_ms =
                2.0 * (cost_.factors_ms() + cost_.patch_occlusion_ms()) * piece.area / std::max(all, 1e-300);
            piece.bound_lux = skipping_ ? bound_of(ceiling_->without_reflection_of(each.id)) : not_asked;
            made.bound_lux = std::max(made.bound_lux, piece.bound_lux);
            made.predicted_ms += piece.predicted_ms;
            made.pieces.push_back(std::move(piece));
        }
        return made;
    }

    double reflectance_of(const Face& face) const {
        double greatest = 0.0;
        const auto include = [&](ObjectId id) {
            if (const Material* material = find_material(scene_, id))
                for (const double band : band_reflectances(*material)) greatest = std::max(greatest, band);
        };
        include(face.material);
        for (const FaceArea& area : face.areas) include(area.material);
        return greatest;
    }

    /// Colour and single pieces of furniture, once interreflection is simulated.
    void skip_parts(EffectsPlan& plan) const {
        PlannedEffect& bands = row_of(plan, Effect::three_bands);
        PlannedEffect& pieces = row_of(plan, Effect::furniture);
        std::vector<SkipCandidate> candidates;
        const bool coloured = bands.state == EffectState::simulated;
        if (skipping_) {
            if (coloured) candidates.push_back({ceiling_->without_colour(), bands.predicted_ms, settings_.colour});
            for (const PlannedPiece& piece : pieces.pieces)
                candidates.push_back(
                    {ceiling_->without_reflection_of(piece.object), piece.predicted_ms, settings_.furniture});
        }
        std::size_t skipped_pieces = 0;
        if (!candidates.empty()) {
            const auto chosen = skipping_->choose(candidates, settings_.tolerance_lux);
            std::size_t k = 0;
            if (coloured && chosen.skipped[k++]) {
                bands.state = EffectState::skipped;
                bands.why += " In one band the photometric figures differ by at most " + figure(bands.bound_lux) +
                             " lx " + where() + ".";
                if (skipping_->are_points()) bands.bound_at_points = skipping_->bounds_of(candidates[0].missing);
            }
            LeavingLight of_pieces;
            for (PlannedPiece& piece : pieces.pieces) {
                if (!chosen.skipped[k++]) continue;
                piece.state = EffectState::skipped;
                plan.black.push_back(piece.object);
                ++skipped_pieces;
                of_pieces += candidates[k - 1].missing;
            }
            if (skipped_pieces > 0) {
                const std::vector<double> bounds = skipping_->bounds_of(of_pieces);
                pieces.bound_lux = greatest(bounds);
                if (skipping_->are_points()) pieces.bound_at_points = bounds;
            }
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
};

}  // namespace

const PlannedEffect& EffectsPlan::row(Effect effect) const {
    const auto found = std::find_if(effects.begin(), effects.end(),
                                    [effect](const PlannedEffect& planned) { return planned.effect == effect; });
    HANEI_CHECK(found != effects.end());
    return *found;
}

double EffectsPlan::skipped_at(const Vec3& position, const Vec3& normal) const {
    return missing ? std::min(missing->at(position, normal), uniform_lux) : 0.0;
}

EffectsPlan plan_effects(const Scene& scene, const Settings& settings, PlanDetail detail) {
    return Planner(scene, settings, detail).plan();
}

const EffectOption* option_of(Effect effect) {
    EffectChoice Settings::*const member = effect == Effect::interreflection ? &Settings::interreflection
                                           : effect == Effect::furniture     ? &Settings::furniture
                                           : effect == Effect::three_bands   ? &Settings::colour
                                                                             : nullptr;
    for (const EffectOption& option : effect_options)
        if (member != nullptr && option.member == member) return &option;
    return nullptr;
}

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
        case Effect::furniture:
            return "furniture as reflector";
        case Effect::closure:
            return "closure";
        case Effect::daylight:
            return "daylight";
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
