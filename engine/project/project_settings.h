/// Settings under the names of the project file: made from the one list of options.
#pragma once

#include "engine/plan/settings.h"

#include <string>

namespace hanei {

/// "max_patch", "accuracy_percent", "tolerance_lx": the option's name, with its unit unless metres.
template <class T>
std::string field_of(const Option<T>& option) {
    std::string field(option.name);
    if (!option.unit.empty() && option.unit != "m") field += '_' + std::string(option.unit);
    for (char& letter : field)
        if (letter == '-' || letter == '/') letter = '_';
    return field;
}

/// Calls `visit(option)` for every option of the list.
template <class Visit>
void for_each_option(Visit visit) {
    std::apply([&](const auto&... option) { (visit(option), ...); }, options);
}

}  // namespace hanei
