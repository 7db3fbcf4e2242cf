#include "engine/geometry/convex_cells.h"
#include "engine/scene/faces.h"
#include "engine/scene/placement.h"

#include <algorithm>
#include <utility>

namespace hanei {
namespace {

/// Bottom, top, then the sides in the order of the bottom's corners.
SolidShape box(const Vec3& size) {
    const double x = size.x / 2.0;
    const double y = size.y / 2.0;
    SolidShape shape;
    for (const double z : {0.0, size.z}) {
        shape.vertices.insert(shape.vertices.end(), {{-x, -y, z}, {x, -y, z}, {x, y, z}, {-x, y, z}});
    }
    shape.faces = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    return shape;
}

SolidShape shape_of(const Part& part) {
    if (const auto* sides = std::get_if<BoxShape>(&part.shape)) return box(sides->size);
    return std::get<SolidShape>(part.shape);
}

Shell shell_of(const Furniture& furniture, const Part& part, int first_face) {
    SolidShape shape = shape_of(part);
    const Placement placed = placement(furniture, part);
    for (Vec3& vertex : shape.vertices) vertex = placed.point(vertex);
    return {furniture.id, std::move(shape.vertices), std::move(shape.faces), first_face};
}

}  // namespace

std::vector<Shell> shells_of(const Scene& scene) {
    std::vector<Shell> shells;
    for (const Furniture& furniture : scene.furniture) {
        int first_face = 0;
        for (const Part& part : furniture.parts) {
            shells.push_back(shell_of(furniture, part, first_face));
            first_face += static_cast<int>(shells.back().faces.size());
        }
    }
    return shells;
}

std::vector<Solid> solids_of(const Scene& scene) {
    std::vector<Solid> solids;
    const std::vector<Shell> shells = shells_of(scene);
    for (std::size_t s = 0; s < shells.size(); ++s) {
        for (ConvexCell& cell : convex_cells(shells[s].vertices, shells[s].faces)) {
            for (int& face : cell.surface) face += shells[s].first_face;
            solids.push_back(
                {shells[s].object, std::move(cell.vertices), std::move(cell.faces), std::move(cell.surface), s});
        }
    }
    return solids;
}

}  // namespace hanei
