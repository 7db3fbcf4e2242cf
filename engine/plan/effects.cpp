#include "engine/base/check.h"
#include "engine/plan/light_ceiling.h"
#include "engine/plan/plan.h"

#include <algorithm>

namespace hanei {

const PlannedEffect& EffectsPlan::row(Effect effect) const {
    const auto found = std::find_if(effects.begin(), effects.end(),
                                    [effect](const PlannedEffect& planned) { return planned.effect == effect; });
    HANEI_CHECK(found != effects.end());
    return *found;
}

double EffectsPlan::skipped_at(const Vec3& position, const Vec3& normal) const {
    return missing ? std::min(missing->at(position, normal), uniform_lux) : 0.0;
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
