/// Where the lines of equal illuminance are named.
#pragma once

#include "ui/view/camera.h"
#include "ui/view/picture_size.h"
#include "ui/view/view_options.h"

#include <string>
#include <vector>

namespace hanei {

struct IsoluxLabel {
    Vec2 at{0.0};  ///< middle of the text, 0..1 from the top left
    double lux = 0.0;
    std::string text;  ///< the figure alone: "300"
};

/// Labels for the visible lines of a picture: on the line, where no other line or edge passes
/// under the text, never over each other or the picture's border. A line too short to carry its
/// figure gets none; a long one gets up to three.
/// `scale` is the text's (1: 12 pixels high). Empty without isolux lines, in photos, and without a
/// display mesh.
/// Cost      30 ms: call it at rest, not while the camera turns or something is dragged.
std::vector<IsoluxLabel> isolux_labels(const Solution& solution, const Camera& camera, const ViewOptions& options,
                                       PixelSize size, double scale = 1.0);

/// Those of the labels whose line still runs under them, for a light that is changing: they neither
/// jump about nor name another line. The camera and the picture are those of the labels.
/// Cost      a sixth of isolux_labels().
std::vector<IsoluxLabel> labels_that_hold(const std::vector<IsoluxLabel>& labels, const Solution& solution,
                                          const Camera& camera, const ViewOptions& options, PixelSize size);

/// A figure in lux as scales and labels show it: 0.5, 75, 1500.
std::string lux_text(double lux);
std::string lux_text(double lux, IlluminanceUnit unit);  ///< its figure in that unit

}  // namespace hanei
