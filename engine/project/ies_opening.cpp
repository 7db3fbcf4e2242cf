#include "engine/project/ies_opening.h"

#include <cmath>

namespace hanei {
namespace {

constexpr int sign(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }

/// Three signs as one figure that reads like the table of the standard: code(-1, +1, 0).
constexpr int code(int width, int length, int height) { return (width + 1) * 9 + (length + 1) * 3 + height + 1; }

bool same_size(double a, double b) { return std::abs(a - b) <= 1e-6; }  // m: the files' own rounding

}  // namespace

std::optional<MeasuredOpeningSize> ies_opening(const IesDimensions& dimensions, bool until_1995) {
    const double w = std::abs(dimensions.width);
    const double l = std::abs(dimensions.length);
    const double h = std::abs(dimensions.height);
    using Shape = OpeningShape;
    const auto round_or = [&](Shape round, Shape other) { return same_size(w, l) ? round : other; };
    switch (code(sign(dimensions.width), sign(dimensions.length), sign(dimensions.height))) {
        case code(0, 0, 0):
            return {{Shape::point, 0.0, 0.0, 0.0}};
        case code(1, 1, 0):
            return {{Shape::rectangle, l, w, 0.0}};
        case code(1, 1, 1):
            return {{Shape::box, l, w, h}};
        case code(-1, -1, 0):  // 2002
            return {{round_or(Shape::circle, Shape::ellipse), l, w, 0.0}};
        case code(-1, 0, 0):  // until 1995
            return {{Shape::circle, w, w, 0.0}};
        case code(-1, 1, 0):  // until 1995, both
        case code(1, -1, 0):
            return {{Shape::ellipse, l, w, 0.0}};
        case code(-1, -1, 1):  // 2002
        case code(-1, 1, 1):   // until 1995, both
        case code(1, -1, 1):
            return {{Shape::vertical_cylinder, l, w, h}};
        case code(-1, 0, 1):  // until 1995
            return {{Shape::vertical_cylinder, w, w, h}};
        case code(-1, -1, -1):  // 2002
            return {{same_size(w, l) && same_size(w, h) ? Shape::sphere : Shape::ellipsoid, l, w, h}};
        case code(-1, 0, -1):
            if (until_1995 && same_size(w, h)) return {{Shape::sphere, w, w, h}};
            return {{Shape::vertical_disc, 0.0, w, h}};
        case code(-1, 1, -1):
            return {{until_1995 ? Shape::ellipsoid : Shape::horizontal_cylinder, l, w, h}};
        case code(1, -1, -1):
            return {{until_1995 ? Shape::ellipsoid : Shape::horizontal_cylinder_90, l, w, h}};
        case code(0, 1, -1):  // until 1995
            return {{Shape::horizontal_cylinder, l, h, h}};
        case code(1, 0, -1):  // until 1995
            return {{Shape::horizontal_cylinder_90, h, w, h}};
        default:
            return std::nullopt;
    }
}

}  // namespace hanei
