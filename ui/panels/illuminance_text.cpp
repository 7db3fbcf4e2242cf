#include "ui/panels/illuminance_text.h"

#include "engine/report/numbers.h"
#include "ui/panels/probe.h"

namespace hanei {
namespace {

IlluminanceUnit shown = IlluminanceUnit::lux;

}  // namespace

void show_illuminance_in(IlluminanceUnit unit) { shown = unit; }
IlluminanceUnit illuminance_unit() { return shown; }

std::string illuminance_figure(double lux) { return short_figure(lux / lux_in(shown)); }

std::string illuminance_text(double lux) {
    std::string text = illuminance_figure(lux);
    if (has_bound(lux)) text.append(" ").append(name_of(shown));
    return text;
}

const char* illuminance_unit_name() { return name_of(shown).data(); }

}  // namespace hanei
