#include "engine/scene/faces.h"
#include "engine/scene/placement.h"

#include <algorithm>
#include <utility>

namespace hanei {
namespace {

/// Bottom, top, then the sides in the order of the bottom's corners.
ConvexShape box(const Vec3& size) {
    const double x = size.x / 2.0;
    const double y = size.y / 2.0;
    ConvexShape shape;
    for (const double z : {0.0, size.z}) {
        shape.vertices.insert(shape.vertices.end(), {{-x, -y, z}, {x, -y, z}, {x, y, z}, {-x, y, z}});
    }
    shape.faces = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    return shape;
}

ConvexShape convex(const Part& part) {
    if (const auto* sides = std::get_if<BoxShape>(&part.shape)) return box(sides->size);
    return std::get<ConvexShape>(part.shape);
}

Solid solid_of(const Furniture& furniture, const Part& part, int first_face) {
    ConvexShape shape = convex(part);
    const Placement placed = placement(furniture, part);
    for (Vec3& vertex : shape.vertices) vertex = placed.point(vertex);
    return {furniture.id, std::move(shape.vertices), std::move(shape.faces), first_face};
}

}  // namespace

std::vector<Solid> solids_of(const Scene& scene) {
    std::vector<Solid> solids;
    for (const Furniture& furniture : scene.furniture) {
        int first_face = 0;
        for (const Part& part : furniture.parts) {
            solids.push_back(solid_of(furniture, part, first_face));
            first_face += static_cast<int>(solids.back().faces.size());
        }
    }
    return solids;
}

}  // namespace hanei
