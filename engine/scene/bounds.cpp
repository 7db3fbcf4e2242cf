#include "engine/scene/faces.h"
#include "engine/scene/placement.h"

#include <algorithm>
#include <limits>

namespace hanei {
namespace {

class BoundsOfPoints {
public:
    void add(const Vec3& point) {
        low_ = glm::min(low_, point);
        high_ = glm::max(high_, point);
    }
    void add(const std::vector<Vec3>& points) {
        for (const Vec3& point : points) add(point);
    }
    Bounds bounds() const { return low_.x <= high_.x ? Bounds{low_, high_} : Bounds{}; }

private:
    Vec3 low_{std::numeric_limits<double>::infinity()};
    Vec3 high_{-std::numeric_limits<double>::infinity()};
};

/// Corners of the opening in the luminaire's frame.
struct OpeningCorners {
    const Scene& scene;
    const Luminaire& luminaire;

    std::vector<Vec3> operator()(const PointOpening&) const { return {Vec3{0.0}}; }
    std::vector<Vec3> operator()(const LineOpening& line) const { return {line.from, line.to}; }
    std::vector<Vec3> operator()(const PolygonOpening& polygon) const { return polygon.region.outline; }
    std::vector<Vec3> operator()(const PolyhedronOpening& polyhedron) const { return polyhedron.vertices; }
    std::vector<Vec3> operator()(const MeasuredOpening&) const {
        const auto* measured = std::get_if<Measured>(&luminaire.distribution);
        const auto same = [measured](const Photometry& photometry) { return photometry.id == measured->photometry; };
        if (measured == nullptr) return {};
        const auto found = std::find_if(scene.photometries.begin(), scene.photometries.end(), same);
        if (found == scene.photometries.end()) return {};
        const Vec3 half = Vec3{found->opening.extent_0, found->opening.extent_90, found->opening.height} / 2.0;
        std::vector<Vec3> corners;
        for (const double x : {-half.x, half.x}) {
            for (const double y : {-half.y, half.y}) {
                for (const double z : {-half.z, half.z}) corners.emplace_back(x, y, z);
            }
        }
        return corners;
    }
};

}  // namespace

Bounds bounds_of(const Scene& scene) {
    BoundsOfPoints all;
    if (scene.room) {
        for (const Vec2& corner : scene.room->plan) {
            all.add(Vec3{corner, scene.room->floor_height});
            all.add(Vec3{corner, scene.room->floor_height + scene.room->height});
        }
    }
    for (const Shell& shell : shells_of(scene)) all.add(shell.vertices);
    for (const FreeSurface& surface : scene.surfaces) all.add(surface.region.outline);
    for (const Luminaire& luminaire : scene.luminaires) {
        all.add(luminaire.position);
        const Placement placed = placement(luminaire);
        for (const Vec3& corner : std::visit(OpeningCorners{scene, luminaire}, luminaire.opening)) {
            all.add(placed.point(corner));
        }
    }
    return all.bounds();
}

}  // namespace hanei
