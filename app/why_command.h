/// `hanei why`: where the light at a place comes from.
#pragma once

#include "app/commands.h"

namespace hanei {

struct WhyRequest {
    std::filesystem::path project;
    std::vector<double> at;                        ///< m: x, y, z
    std::vector<double> normal = {0.0, 0.0, 1.0};  ///< of the place
    std::string point;                             ///< a calculation point by name or number from 1, in place of `at`
    std::optional<std::filesystem::path> json;
    SettingsChange change;
};
int why_command(const WhyRequest& request);

}  // namespace hanei
