/// Part of a patch or of a luminous piece, with the places that stand for it.
#pragma once

#include "engine/base/vector.h"

#include <array>
#include <span>
#include <vector>

namespace hanei {

/// A convex polygon, a line of two ends, or a point. Its nodes stand for it with equal weight:
///
///     centre +- along +- across      its principal axes, as long as its standard deviations
///
/// Their mean is that of every quadratic over the cell (of a rectangle or an ellipse: of every cubic):
/// the four Gauss points of a rectangle, two of a line, one of a point.
struct FlatCell {
    /// Needs     a convex polygon's corners in order, two ends, or one point.
    explicit FlatCell(Polygon corners);

    /// A polygon of which only the size is asked.
    static FlatCell without_nodes(Polygon corners);

    std::span<const Vec3> nodes() const { return {places.data(), count}; }

    /// Two parts, cut through the centre across the longest axis; none for a point.
    std::vector<FlatCell> halves() const;

    Polygon corners;
    double size = 0.0;  ///< area or length; 1 for a point
    Vec3 centre{0.0};
    Vec3 along{0.0}, across{0.0};
    std::array<Vec3, 4> places;
    std::size_t count = 0;  ///< of nodes; 0 without area

private:
    FlatCell() = default;
};

}  // namespace hanei
