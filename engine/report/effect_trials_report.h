/// What effects really add and take, as people and programs read it.
#pragma once

#include "engine/study/effect_trials.h"

#include <string>

namespace hanei {

std::string trials_text(const EffectTrials& trials);
/// An object of two: "plan", as plan_json has it, and "measured".
std::string plan_json(const EffectsPlan& plan, const EffectTrials& trials);

}  // namespace hanei
