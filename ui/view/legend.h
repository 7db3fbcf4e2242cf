/// What stands beside and under a picture: the colour scale and the caption.
#pragma once

#include "ui/view/image.h"
#include "ui/view/view_options.h"

#include <string>
#include <string_view>

namespace hanei {

/// The colour bar with round lux values, quantity, unit, part and kind of scale; dark lettering on
/// a nearly white rounded card. Its width follows from its lettering. `scale` enlarges the
/// lettering on dense displays. The same picture in the window and in exported files.
/// Needs     height_px of 160 x scale at least, so that the lettering fits; smaller is taken as that.
/// `part` is written under the quantity in place of the shown part's name, when not empty.
Image legend_image(const ViewOptions& options, int height_px, double scale = 1.0, std::string_view part = {});

/// Width that legend_image will have.
int legend_width(const ViewOptions& options, double scale = 1.0);

/// First line: title and part. Second: how it was computed and how wrong it can be.
struct Caption {
    std::string title;
    std::string detail;
};
Caption caption_of(const Solution& solution, const ViewOptions& options);

/// "Total illuminance", "Direct light only", ... for headings.
std::string heading_of(LightPart part);

}  // namespace hanei
