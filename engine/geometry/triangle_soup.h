/// Triangles as files of pictures bring them: without neighbours, corners that should be one a hair
/// apart, some of them without area or there twice.
#pragma once

#include "engine/base/vector.h"

#include <array>
#include <cstddef>
#include <vector>

namespace hanei {

struct Triangle {
    std::array<int, 3> corner{};  ///< vertex numbers, counter-clockwise seen from the front
    int label = 0;                ///< carried along: what it is made of
    bool operator==(const Triangle&) const = default;
};

struct TriangleSoup {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
};

/// What weld() had to do.
struct SoupRepairs {
    std::size_t without_area = 0;  ///< triangles left out: thinner than the distance
    std::size_t repeated = 0;      ///< triangles left out: there already, front on the same side
    std::size_t split = 0;         ///< triangles cut because a corner of a neighbour lay on their edge
};

/// Makes one vertex of vertices nearer to each other than `distance`, drops triangles without area or
/// there twice, and cuts triangles at corners of others that lie on their open edges.
///
/// Needs     finite vertices, corners that count them, distance > 0.
/// Returns   what was done. Equal on every run.
/// Weak when more than 20 000 vertices lie on open edges: then nothing is cut.
/// Cost      n log n.
SoupRepairs weld(TriangleSoup& soup, double distance);

/// Normal times area.
Vec3 vector_area(const std::vector<Vec3>& vertices, const Triangle& triangle);

}  // namespace hanei
