#include "ui/panels/time_left.h"

#include "ui/panels/language.h"

#include <cmath>

namespace hanei {

std::string time_left_text(std::optional<double> seconds) {
    if (!seconds || !std::isfinite(*seconds)) return {};
    if (*seconds < 90.0) return say("{:.0f} s left", std::ceil(*seconds));
    return say("{:.0f} min left", std::ceil(*seconds / 60.0));
}

std::optional<double> TimeLeft::seconds(Stage stage, float fraction, Clock::time_point now) {
    if (stage != stage_) {
        stage_ = stage;
        begun_ = now;
    }
    const double passed = std::chrono::duration<double>(now - begun_).count();
    if (passed < 0.5 || fraction < 0.02F) return std::nullopt;
    const double share = static_cast<double>(fraction);
    return passed * (1.0 - share) / share;
}

}  // namespace hanei
