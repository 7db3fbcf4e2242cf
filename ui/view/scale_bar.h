/// The bar in a drawing that shows how long a length of the room is in it.
#pragma once

#include "ui/view/camera.h"
#include "ui/view/length_unit.h"

#include <optional>
#include <string>

namespace hanei {

struct ScaleBar {
    double metres = 1.0;
    double pixels = 100.0;
    int fields = 2;    ///< that it is divided into, dark and light by turns
    std::string text;  ///< "2 m", "50 cm", "5 ft"
};

/// The longest round length (1, 2 or 5 times a power of ten, of feet also 1, 2 or 6 inches) that takes
/// `most` pixels at most, in a picture so many pixels high.
///
/// Returns   nothing for perspective, where no length holds for all of the picture, and nothing where
///           lengths are of no size on the screen.
std::optional<ScaleBar> scale_bar(const Camera& camera, double picture_height, double most, LengthUnit unit);

}  // namespace hanei
