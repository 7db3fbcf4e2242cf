#include "engine/plan/settings.h"

#include <algorithm>

namespace hanei {

std::string_view name_of(Method method) {
    switch (method) {
        case Method::paper:
            return "paper";
        case Method::paper_closed:
            return "paper-closed";
        case Method::patch:
            return "patch";
        case Method::linear:
            return "linear";
    }
    return "";
}

std::optional<Method> method_named(std::string_view name) {
    const auto found = std::find_if(methods.begin(), methods.end(), [&](Method each) { return name_of(each) == name; });
    if (found == methods.end()) return std::nullopt;
    return *found;
}

std::string_view name_of(EffectChoice choice) {
    switch (choice) {
        case EffectChoice::by_bound:
            return "by-bound";
        case EffectChoice::always:
            return "always";
        case EffectChoice::never:
            return "never";
    }
    return "";
}

std::optional<EffectChoice> effect_choice_named(std::string_view name) {
    const auto found = std::find_if(effect_choices.begin(), effect_choices.end(),
                                    [&](EffectChoice each) { return name_of(each) == name; });
    if (found == effect_choices.end()) return std::nullopt;
    return *found;
}

bool is_of_the_paper(Method method) { return method == Method::paper || method == Method::paper_closed; }

}  // namespace hanei
