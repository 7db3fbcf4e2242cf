/// What stands beside and under a picture: the colour scale and the caption.
#pragma once

#include "ui/view/image.h"
#include "ui/view/view_options.h"

#include <string>
#include <string_view>
#include <vector>

namespace hanei {

/// The colour bar with round lux values, quantity, unit, part and kind of scale; dark lettering on
/// a nearly white rounded card. Its width follows from its lettering. `scale` enlarges the
/// lettering on dense displays. The same picture in the window and in exported files.
/// Needs     height_px of 160 x scale at least, so that the lettering fits; smaller is taken as that.
/// `part` is written under the quantity in place of the shown part's name, when not empty.
Image legend_image(const ViewOptions& options, int height_px, double scale = 1.0, std::string_view part = {});

/// Width that legend_image will have.
int legend_width(const ViewOptions& options, double scale = 1.0);

/// One row of the key to the shadow classes.
struct ClassRow {
    LightClass kind = LightClass::lit;
    std::string name;    ///< "Lit", ...
    std::string counts;  ///< "1240 patches, 61.2 m²"
};
/// From lit to unlit, with what of the shown luminaire's light they hold; no counts without shadows.
std::vector<ClassRow> class_rows(const Solution* solution, const ViewOptions& options);

/// Whose shadows are shown: a luminaire's name, "luminaire 2", or "all luminaires".
std::string shadows_of_text(const Scene& scene, ObjectId luminaire);

/// What the lines of shadow outlines mean, in a sentence with its limit.
std::string_view outline_text();

/// The key to the shadow classes, as wide as class_legend_width().
Image class_legend_image(const Solution& solution, const ViewOptions& options, int height_px, double scale = 1.0);
int class_legend_width(double scale = 1.0);

/// First line: title and part. Second: how it was computed and how wrong it can be.
struct Caption {
    std::string title;
    std::string detail;
};
Caption caption_of(const Solution& solution, const ViewOptions& options);

/// "Total illuminance", "Direct light only", ... for headings.
std::string heading_of(LightPart part);

}  // namespace hanei
