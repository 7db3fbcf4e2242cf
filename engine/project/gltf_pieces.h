/// The surfaces of a scene cut into triangles, for programs that know nothing else.
#pragma once

#include "engine/scene/faces.h"

#include <cstdint>
#include <map>

namespace hanei {

struct TriangleList {
    std::vector<Vec3> places;
    std::vector<std::uint32_t> corners;  ///< three a triangle, counter-clockwise from the front

    void add(const Polygon& convex);
    void add(const Region& region);
};

/// The faces of the room by their materials, sub-areas cut out and laid in.
std::map<ObjectId, TriangleList> room_pieces(const Scene& scene);

/// One list a part, in the furniture's own frame.
std::vector<TriangleList> furniture_pieces(const Furniture& furniture);

/// The luminous opening in the luminaire's own frame; empty for points and lines.
TriangleList opening_pieces(const Luminaire& luminaire, const Scene& scene);

}  // namespace hanei
