#include "engine/base/tolerance.h"
#include "engine/geometry/polygon.h"
#include "engine/scene/faces.h"
#include "engine/scene/placement.h"
#include "engine/scene/scene_findings.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

double distance_to_edge(const Vec2& p, const Vec2& a, const Vec2& b) {
    const double along = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    return glm::distance(p, a + along * (b - a));
}

/// How far a place lies outside the plan; 0 inside.
double outside_plan(const std::vector<Vec2>& plan, const Vec2& p) {
    bool inside = false;
    double nearest = glm::distance(p, plan[0]);
    for (std::size_t k = 0; k < plan.size(); ++k) {
        const Vec2& a = plan[k];
        const Vec2& b = plan[(k + 1) % plan.size()];
        nearest = std::min(nearest, distance_to_edge(p, a, b));
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside ? 0.0 : nearest;
}

double outside_room(const Room& room, const Vec3& p) {
    const double above = p.z - (room.floor_height + room.height);
    return std::max({0.0, above, room.floor_height - p.z, outside_plan(room.plan, Vec2{p})});
}

double farthest_outside(const Room& room, const std::vector<Vec3>& places) {
    double farthest = 0.0;
    for (const Vec3& place : places) farthest = std::max(farthest, outside_room(room, place));
    return farthest;
}

/// Depth below the surface of a convex solid; negative outside.
double depth_inside(const Solid& solid, const Vec3& p) {
    double depth = HUGE_VAL;
    for (const std::vector<int>& face : solid.faces) {
        Polygon loop;
        for (const int vertex : face) loop.push_back(solid.vertices[static_cast<std::size_t>(vertex)]);
        depth = std::min(depth, -glm::dot(p - loop[0], unit_normal(loop)));
    }
    return depth;
}

struct OpeningPlaces {
    std::vector<Vec3> operator()(const PointOpening&) const { return {Vec3{0.0}}; }
    std::vector<Vec3> operator()(const MeasuredOpening&) const { return {Vec3{0.0}}; }
    std::vector<Vec3> operator()(const LineOpening& line) const { return {line.from, line.to}; }
    std::vector<Vec3> operator()(const PolygonOpening& polygon) const { return polygon.region.outline; }
    std::vector<Vec3> operator()(const PolyhedronOpening& solid) const { return solid.vertices; }
};

/// Where things may not be: shared by all objects of one scene.
class Surroundings {
public:
    explicit Surroundings(const Scene& scene)
        : scene_(scene), solids_(solids_of(scene)), diameter_(bounds_of(scene).diameter()) {}

    double outside(const std::vector<Vec3>& places) const {
        const double distance = scene_.room.has_value() ? farthest_outside(*scene_.room, places) : 0.0;
        return distance > thickness_ ? distance : 0.0;
    }

    /// Does the wall, floor or ceiling stand right in front of the face?
    bool faces_out(const Vec3& place, const Vec3& normal) const {
        return outside({place}) == 0.0 && outside({place + in_front_ * normal}) > 0.0;
    }

    /// The name of furniture that one of the places is inside of, quoted; empty when there is none.
    std::string furniture_around(const std::vector<Vec3>& places) const {
        for (const Solid& solid : solids_)
            for (const Vec3& place : places)
                if (depth_inside(solid, place) > thickness_) return name_of(solid.object);
        return {};
    }

private:
    std::string name_of(ObjectId id) const {
        const auto found = std::find_if(scene_.furniture.begin(), scene_.furniture.end(),
                                        [id](const Furniture& furniture) { return furniture.id == id; });
        return '"' + (found->name.empty() ? "furniture " + std::to_string(id.value) : found->name) + '"';
    }

    const Scene& scene_;
    std::vector<Solid> solids_;
    double diameter_;
    double thickness_ = tolerance::planar * diameter_;
    /// m: with less room than that before it nothing lights or is lit; in a model the same share of it.
    double in_front_ = std::min(0.02, 0.004 * diameter_);
};

void check_luminaire(const Surroundings& around, const Scene& scene, ObjectFindings& object,
                     const Luminaire& luminaire) {
    const Placement placed = placement(luminaire);
    std::vector<Vec3> places = std::visit(OpeningPlaces{}, luminaire.opening);
    Vec3 middle{0.0};
    for (Vec3& place : places) {
        place = placed.point(place);
        middle += place / static_cast<double>(places.size());
    }
    places.push_back(middle);  // an opening whose corners all stick out of a desk is in it all the same
    const double outside = around.outside(places);
    if (outside > 0.0)
        object.warn("position", "it reaches " + figure(outside) +
                                    " m out of the room; light from there does not get in; move it inside");
    const std::string furniture = around.furniture_around(places);
    if (!furniture.empty())
        object.warn("position", "it is partly or wholly inside " + furniture + ", which holds its light back; move it");
    const auto* const polygon = std::get_if<PolygonOpening>(&luminaire.opening);
    if (polygon == nullptr || !scene.room.has_value() || outside > 0.0) return;
    const Polygon outline = placed.region(polygon->region).outline;
    if (around.faces_out(centroid(outline), unit_normal(outline)))
        object.warn("opening.outline",
                    "it shines at the wall, floor or ceiling right in front of it; reverse its corners "
                    "if it should shine into the room");
}

void check_grid_place(const Surroundings& around, ObjectFindings& object, const CalculationGrid& grid) {
    const Vec3 far_corner = grid.corner + grid.along + grid.across;
    const double outside =
        around.outside({grid.corner, grid.corner + grid.along, grid.corner + grid.across, far_corner});
    if (outside > 0.0)
        object.warn("corner", "it reaches " + figure(outside) + " m out of the room; its points there get no light");
    else if (around.faces_out(0.5 * (grid.corner + far_corner), glm::normalize(glm::cross(grid.along, grid.across))))
        object.warn("across",
                    "it is lit from the wall, floor or ceiling it lies on; reverse one of its sides and move its "
                    "corner, so that along x across points into the room");
}

void check_point_place(const Surroundings& around, ObjectFindings& object, const CalculationPoint& point) {
    if (around.outside({point.position}) > 0.0)
        object.warn("position", "it lies outside the room and gets no light; move it inside");
    else if (around.faces_out(point.position, point.normal))
        object.warn("normal", "it is lit from the wall, floor or ceiling it lies on; reverse its normal");
    const std::string furniture = around.furniture_around({point.position});
    if (!furniture.empty()) object.warn("position", "it lies inside " + furniture + " and gets no light; move it out");
}

}  // namespace

void check_places(SceneChecks& checks) {
    const Scene& scene = checks.scene;
    const Surroundings around(scene);
    const std::vector<Shell> shells = shells_of(scene);
    std::size_t next = 0;
    for (std::size_t i = 0; i < scene.furniture.size(); ++i) {
        double outside = 0.0;
        for (std::size_t k = 0; k < scene.furniture[i].parts.size(); ++k)
            outside = std::max(outside, around.outside(shells[next++].vertices));
        if (outside > 0.0)
            checks.about("furniture", i, "furniture", scene.furniture[i].name, scene.furniture[i].id)
                .warn("position", "it reaches " + figure(outside) + " m out of the room; move it inside");
    }
    for (std::size_t i = 0; i < scene.luminaires.size(); ++i) {
        const Luminaire& luminaire = scene.luminaires[i];
        ObjectFindings object = checks.about("luminaires", i, "luminaire", luminaire.name, luminaire.id);
        check_luminaire(around, scene, object, luminaire);
    }
    for (std::size_t i = 0; i < scene.grids.size(); ++i) {
        const CalculationGrid& grid = scene.grids[i];
        ObjectFindings object = checks.about("grids", i, "grid", grid.name, grid.id);
        check_grid_place(around, object, grid);
    }
    for (std::size_t i = 0; i < scene.points.size(); ++i) {
        const CalculationPoint& point = scene.points[i];
        ObjectFindings object = checks.about("points", i, "point", point.name, point.id);
        check_point_place(around, object, point);
    }
}

}  // namespace hanei
