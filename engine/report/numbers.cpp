#include "engine/report/numbers.h"

#include "engine/report/report.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace hanei {

bool has_bound(double error_lux) {
    constexpr double no_bound = 1e29;  // far above any illuminance
    return error_lux < no_bound;
}

std::string csv_field(std::string_view text) {
    if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

std::string illuminance_text(Illuminance value, double error_lux) {
    if (!has_bound(error_lux)) return fmt::format("{:.0f} lx, no bound", value.value);
    if (error_lux <= 0.0) return fmt::format("{:.1f} lx", value.value);
    // One digit of the error, and the value to the same place.
    const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(error_lux))), 0, 6);
    return fmt::format("{:.{}f} ± {:.{}f} lx", value.value, digits, error_lux, digits);
}

}  // namespace hanei
