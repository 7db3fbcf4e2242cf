#include "ui/panels/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

LengthUnit length_unit = LengthUnit::metre;
IlluminanceUnit illuminance_unit = IlluminanceUnit::lux;

constexpr double inch = 0.0254;  // m
constexpr double foot = 0.3048;
constexpr double foot_candle = 1.0 / (foot * foot);  // lx: a lumen a square foot
constexpr double degrees_of_a_radian = 57.295779513082320877;

constexpr std::array lengths{UnitWord{"m", 1.0},   UnitWord{"cm", 0.01}, UnitWord{"mm", 0.001},
                             UnitWord{"ft", foot}, UnitWord{"'", foot},  UnitWord{"′", foot},
                             UnitWord{"in", inch}, UnitWord{"\"", inch}, UnitWord{"″", inch}};
constexpr std::array illuminances{UnitWord{"lx", 1.0}, UnitWord{"fc", foot_candle}, UnitWord{"klx", 1000.0}};
constexpr std::array angles{UnitWord{"°", 1.0}, UnitWord{"deg", 1.0}, UnitWord{"rad", degrees_of_a_radian}};
constexpr std::array shares{UnitWord{"%", 1.0}};
constexpr std::array temperatures{UnitWord{"K", 1.0}, UnitWord{"kK", 1000.0}};
constexpr std::array fluxes{UnitWord{"lm", 1.0}, UnitWord{"klm", 1000.0}};
constexpr std::array luminances{UnitWord{"cd/m²", 1.0}, UnitWord{"cd/m2", 1.0}, UnitWord{"kcd/m²", 1000.0}};

ShownUnit shown_length() {
    switch (length_unit) {
        case LengthUnit::metre:
            return {"m", 1.0, 1.0, 0, false, lengths};
        case LengthUnit::centimetre:
            return {"cm", 0.01, 0.01, 2, false, lengths};
        case LengthUnit::millimetre:
            return {"mm", 0.001, 0.001, 3, false, lengths};
        case LengthUnit::feet_inches:
            return {"ft", inch, foot, 0, true, lengths};
    }
    return {};
}

/// To the sixteenth of an inch, as a rule is divided.
std::string feet_and_inches(double metres) {
    constexpr long parts = 16;
    if (!(std::abs(metres) < 1e6)) return fmt::format("{:.0f}'", metres / foot);
    const long all = std::lround(std::abs(metres) / inch * parts);
    const long feet = all / (12 * parts), inches = all / parts % 12;
    long above = all % parts, below = parts;
    while (above != 0 && above % 2 == 0) above /= 2, below /= 2;
    const std::string fraction = above != 0 ? fmt::format(" {}/{}", above, below) : std::string();
    return fmt::format("{}{}'-{}{}\"", metres < 0.0 && all > 0 ? "-" : "", feet, inches, fraction);
}

}  // namespace

void show_units(LengthUnit length, IlluminanceUnit illuminance) {
    length_unit = length;
    illuminance_unit = illuminance;
}

ShownUnit shown_unit(std::string_view unit) {
    if (unit == "m") return shown_length();
    if (unit == "lx" && illuminance_unit == IlluminanceUnit::foot_candle)
        return {"fc", foot_candle, foot_candle, -1, false, illuminances};
    if (unit == "lx") return {unit, 1.0, 1.0, 0, false, illuminances};
    if (unit == "°") return {unit, 1.0, 1.0, 0, false, angles};
    if (unit == "%") return {unit, 1.0, 1.0, 0, false, shares};
    if (unit == "K") return {unit, 1.0, 1.0, 0, false, temperatures};
    if (unit == "lm") return {unit, 1.0, 1.0, 0, false, fluxes};
    if (unit == "cd/m²") return {unit, 1.0, 1.0, 0, false, luminances};
    return {unit, 1.0, 1.0, 0, false, {}};
}

std::string figure_text(double value, const ShownUnit& unit, int decimals) {
    if (unit.feet_inches) return feet_and_inches(value);
    return fmt::format("{:.{}f}", value / unit.worth, std::max(0, decimals - unit.fewer_decimals));
}

std::string with_unit(double value, std::string_view unit, int decimals) {
    const ShownUnit shown = shown_unit(unit);
    const std::string figure = figure_text(value, shown, decimals);
    return shown.feet_inches || shown.label.empty() ? figure : fmt::format("{} {}", figure, shown.label);
}

}  // namespace hanei
