/// The units in which figures are shown and typed, as the preferences say. The scene keeps metres and lux.
#pragma once

#include "engine/base/expression.h"
#include "ui/panels/preferences.h"

#include <span>
#include <string>
#include <string_view>

namespace hanei {

/// For all that is drawn from here on; the UI thread alone.
void show_units(LengthUnit length, IlluminanceUnit illuminance);

/// How figures of one unit are shown.
struct ShownUnit {
    std::string_view label;           ///< "m", "cm", "lx", "fc"
    double worth = 1.0;               ///< of a figure on the screen, in the unit of the field
    double bare = 1.0;                ///< of a typed figure without a unit
    int fewer_decimals = 0;           ///< than in the unit of the field
    bool feet_inches = false;         ///< shown as 5'-3 1/2"; a figure on the screen counts inches
    std::span<const UnitWord> words;  ///< that may be typed
};

/// For a field whose values are kept in "m", "lx", "°", "%", "K", "lm" or "cd/m²"; any other unit is
/// shown as it is and takes no words.
ShownUnit shown_unit(std::string_view unit);

/// The figure alone, as a field shows it: "1.250", "125.0", 4'-1 1/4".
std::string figure_text(double value, const ShownUnit& unit, int decimals);

/// The figure with its unit: "1.25 m", "412 lx".
std::string with_unit(double value, std::string_view unit, int decimals);

}  // namespace hanei
