/// Figures of illuminance as the user likes them: in lux or in foot-candles.
#pragma once

#include "ui/view/illuminance_unit.h"

#include <string>

namespace hanei {

/// For all that is drawn from here on; the UI thread alone.
void show_illuminance_in(IlluminanceUnit unit);
IlluminanceUnit illuminance_unit();

/// "412", of 3 significant digits, in the shown unit; without the unit.
std::string illuminance_figure(double lux);
/// "412 lx"
std::string illuminance_text(double lux);
/// "lx" or "fc", for headings.
const char* illuminance_unit_name();

}  // namespace hanei
