/// What of a solution is drawn, and how figures become colours.
#pragma once

#include "engine/solution/solution.h"
#include "ui/view/illuminance_unit.h"

#include <string>
#include <string_view>
#include <vector>

namespace hanei {

enum class LightPart { total, direct, interreflected, unshadowed };
enum class Scale { false_colour, photo };
enum class ColourSteps { logarithmic, linear, standard_steps };  ///< EN 12464-1 scale of illuminance

std::string_view name_of(LightPart part);     ///< "total", ... as the command line says it
std::string_view name_of(Scale scale);        ///< "false-colour", "photo"
std::string_view name_of(ColourSteps steps);  ///< "logarithmic", "linear", "EN 12464-1 steps"

/// The part of the light at a vertex of the picture, lx.
float value_of(const DisplayVertex& vertex, LightPart part);

/// Whether the solution holds this part: `unshadowed` is computed on request only.
bool has_part(const Solution& solution, LightPart part);

/// Range of the colour scale, lx. One range a project, not one a picture, so that pictures compare.
struct LuxRange {
    double low = 10.0;
    double high = 1000.0;
    bool operator==(const LuxRange&) const = default;
};
/// Rounded to the EN steps around what the surfaces of the solution show (all but the darkest 4 %
/// and the brightest 0.3 % of their area); never wider than about 1 to 100, so that a black ceiling
/// does not take the colours away from the desks.
LuxRange suggested_range(const Solution& solution);

struct ViewOptions {
    LightPart part = LightPart::total;
    Scale scale = Scale::false_colour;
    ColourSteps steps = ColourSteps::logarithmic;
    LuxRange range;
    bool isolux = true;  ///< lines of equal illuminance with labels (false colour only)
    bool mesh_lines = false;
    bool grids = true;  ///< calculation points
    bool luminaires = true;
    bool dark_background = false;                 ///< for a dark window; pictures for paper are light
    bool shadow_classes = false;                  ///< patches by how light reaches them, in place of the light
    bool shadow_outlines = false;                 ///< borders of umbra and penumbra, over any picture
    ObjectId shadows_of;                          ///< a luminaire; none: of all
    double exposure = 0.0;                        ///< photo: stops added to the automatic exposure
    bool marks_clipped = false;                   ///< what lies outside the range is hatched
    std::vector<double> isolux_levels{};          ///< lx, rising; none: the steps of the scale
    IlluminanceUnit unit = IlluminanceUnit::lux;  ///< of every figure in the picture
    bool values = false;                          ///< figures at the points of calculation grids
    bool pins = false;                            ///< figures beside calculation points
    ObjectId values_of;                           ///< a calculation grid whose figures come first
    bool difference = false;  ///< the figures are differences (difference.h): -range.high to range.high
    bool operator==(const ViewOptions&) const = default;
};

/// Steps of the illuminance scale within the range, both ends included where they are steps
/// (EN 12464-1: 20 30 50 75 100 150 ... lx, continued alike into other decades).
std::vector<double> standard_steps(const LuxRange& range);

/// The figures that a scale names, lx: round ones in the shown unit; for the steps of EN 12464-1 these.
/// Linear scales have some ten at equal distances.
std::vector<double> scale_steps(const ViewOptions& options);

/// Lines of equal illuminance, lx: the user's own, else the steps of the scale.
std::vector<double> isolux_levels(const ViewOptions& options);

/// As differences from -range to +range are shown: in false colours, without lines and dots.
ViewOptions as_difference(ViewOptions options, double range);

/// What the project says of its scale, and back. Words that are no steps are taken for "log".
void take_scale(ViewOptions& options, const ColourScale& scale);
ColourScale scale_of(const ViewOptions& options);

}  // namespace hanei
