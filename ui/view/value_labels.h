/// Figures at calculation points and grids, placed so that none covers another.
#pragma once

#include "ui/view/camera.h"
#include "ui/view/picture_size.h"
#include "ui/view/view_options.h"

#include <string>
#include <vector>

namespace hanei {

struct ValueLabel {
    enum class Kind {
        figure,    ///< of a grid's point
        least,     ///< the least of its grid
        greatest,  ///< the greatest of its grid
        middle,    ///< the point of a grid that is nearest to its mean
        point      ///< of a calculation point, beside it: with its error bar and a line to it
    };
    Kind kind = Kind::figure;
    Vec2 at{0.0};     ///< middle of the text, 0..1 from the top left
    Vec2 place{0.0};  ///< what it is of
    std::string text;
    ObjectId object;  ///< the grid or calculation point
};

/// Half the width and height of a label's ground, in pixels; `scale` as below.
Vec2 half_size(const ValueLabel& label, double scale);

/// Labels of what is seen in a picture: calculation points with `options.pins`, grids with
/// `options.values`. The grid `options.values_of` comes first and has as many figures as there is room
/// for; of the others every second, third, ... row and column, as few as it takes.
/// `scale` is the text's (1: 12 pixels high). Empty in photos, and for parts that values do not have
/// (unshadowed).
/// Cost      10 ms: call it at rest, not while the camera turns.
std::vector<ValueLabel> value_labels(const Solution& solution, const Camera& camera, const ViewOptions& options,
                                     PixelSize size, double scale = 1.0);

/// "412" of three significant digits, in the unit.
std::string value_text(double lux, IlluminanceUnit unit);
/// The same, with its sign when it is a difference.
std::string value_text(double lux, const ViewOptions& options);

}  // namespace hanei
