/// Triangles sorted into the shells they form: closed ones, which bound a solid, and open ones.
#pragma once

#include "engine/geometry/triangle_soup.h"

namespace hanei {

/// Triangles that hang together by their edges and are wound alike.
///
/// Holds     vertices of its own: where the shell touches itself they stand twice, so that every edge
///           belongs to one triangle or two, which run along it in opposite directions.
struct TriangleShell {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    bool closed = false;     ///< then its fronts look outward
    double volume = 0.0;     ///< m3, of a closed one: more than 0
    std::size_t turned = 0;  ///< triangles that are wound the other way in the soup
    bool one_sided = false;  ///< no winding makes its fronts agree (a Moebius strip); never closed
};

/// Across an edge of two triangles they belong together; across one of more, those that bound the same
/// space from inside do (so boxes that touch along an edge or a face stay two). Closed shells without
/// volume are open.
///
/// Needs     a soup that was welded.
/// Returns   shells in the order of their first triangles. Of open ones as many triangles as possible
///           keep their winding.
/// Cost      n log n.
std::vector<TriangleShell> shells_of(const TriangleSoup& soup);

/// How often the shell winds around a place: 1 inside a closed one, 0 outside.
double winding_number(const TriangleShell& shell, const Vec3& place);

}  // namespace hanei
