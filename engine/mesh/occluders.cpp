#include "engine/geometry/polygon.h"
#include "engine/mesh/contact.h"
#include "engine/mesh/pieces.h"
#include "engine/mesh/mesh.h"
#include "engine/scene/placement.h"

#include <algorithm>
#include <numeric>

namespace hanei {

namespace {

/// Every place of the scene that light can start from or arrive at: corners of faces, luminaires'
/// extents, points and grids.
std::vector<Vec3> places_of(const Scene& scene, const std::vector<Face>& faces) {
    std::vector<Vec3> places;
    for (const Face& face : faces) {
        places.insert(places.end(), face.region.outline.begin(), face.region.outline.end());
    }
    for (const Luminaire& luminaire : scene.luminaires) {
        const Placement placed = placement(luminaire);
        places.push_back(placed.position);
        if (const auto* line = std::get_if<LineOpening>(&luminaire.opening)) {
            places.insert(places.end(), {placed.point(line->from), placed.point(line->to)});
        } else if (const auto* flat = std::get_if<PolygonOpening>(&luminaire.opening)) {
            for (const Vec3& corner : flat->region.outline) places.push_back(placed.point(corner));
        } else if (const auto* solid = std::get_if<PolyhedronOpening>(&luminaire.opening)) {
            for (const Vec3& corner : solid->vertices) places.push_back(placed.point(corner));
        }
    }
    for (const CalculationPoint& point : scene.points) places.push_back(point.position);
    for (const CalculationGrid& grid : scene.grids) {
        for (const Vec3& corner : {grid.corner, grid.corner + grid.along, grid.corner + grid.across}) {
            places.push_back(corner);
        }
        places.push_back(grid.corner + grid.along + grid.across);
    }
    return places;
}

}  // namespace

OccluderSet occluders_of(const Scene& scene) {
    const Contacts contacts(scene);
    std::vector<ConvexBody> bodies;
    for (const SolidBody& solid : contacts.solids()) bodies.push_back(solid.body);
    const std::vector<Vec3> places = places_of(scene, contacts.faces());
    for (std::size_t f = 0; f < contacts.faces().size(); ++f) {
        if (contacts.solid_of(f) >= 0) continue;
        const Face& face = contacts.faces()[f];
        const Plane plane{face.region.outline.front(), face.normal};
        const bool something_behind = std::any_of(places.begin(), places.end(), [&](const Vec3& place) {
            return plane.height(place) < -contacts.same_place();
        });
        if (!something_behind) continue;
        for (Polygon& piece : pieces_of(face.region, face.normal)) {
            std::vector<int> loop(piece.size());
            std::iota(loop.begin(), loop.end(), 0);
            bodies.push_back({std::move(piece), {std::move(loop)}, face.ref.object.value});
        }
    }
    for (const ConvexBody& opening : contacts.openings()) bodies.push_back(opening);
    return OccluderSet(std::move(bodies));
}

}  // namespace hanei
