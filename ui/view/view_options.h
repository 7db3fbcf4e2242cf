/// What of a solution is drawn, and how figures become colours.
#pragma once

#include "engine/solution/solution.h"

#include <string>
#include <string_view>
#include <vector>

namespace hanei {

enum class LightPart { total, direct, interreflected, unshadowed };
enum class Scale { false_colour, photo };
enum class ColourSteps { logarithmic, linear, standard_steps };  ///< EN 12464-1 scale of illuminance

std::string_view name_of(LightPart part);
std::string_view name_of(Scale scale);

/// Range of the colour scale, lx. One range a project, not one a picture, so that pictures compare.
struct LuxRange {
    double low = 10.0;
    double high = 1000.0;
    bool operator==(const LuxRange&) const = default;
};
/// Rounded to the EN steps around what the surfaces of the solution show (1st to 99th percentile).
LuxRange suggested_range(const Solution& solution);

struct ViewOptions {
    LightPart part = LightPart::total;
    Scale scale = Scale::false_colour;
    ColourSteps steps = ColourSteps::logarithmic;
    LuxRange range;
    bool isolux = true;         ///< lines of equal illuminance with labels
    bool mesh_lines = false;
    bool grids = true;          ///< calculation points
    bool luminaires = true;
    double exposure = 0.0;      ///< photo: stops added to the automatic exposure
    bool operator==(const ViewOptions&) const = default;
};

/// Steps of the illuminance scale within the range (EN 12464-1: 20 30 50 75 100 150 ... lx).
std::vector<double> standard_steps(const LuxRange& range);

}  // namespace hanei
