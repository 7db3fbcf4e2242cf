#include "ui/view/pick.h"

#include "engine/geometry/polygon.h"
#include "engine/scene/faces.h"
#include "ui/view/cell_field.h"
#include "ui/view/left_out.h"
#include "ui/view/luminaire_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hanei {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double catch_radius = 0.012;  // of the picture's height: 10 pixels of 800, a fingertip of a mouse
constexpr double preferred_by = 0.15;   // m: a luminaire set into a shelf or a ceiling panel still wins

/// Distance along the ray to a plane's front or back; `never` when it runs beside it.
double distance_to_plane(const Ray& ray, const Vec3& on_plane, const Vec3& normal) {
    const double against = glm::dot(ray.direction, normal);
    const double distance = glm::dot(on_plane - ray.origin, normal) / against;
    return std::isfinite(distance) && distance > 0.0 ? distance : never;
}

bool inside(const Polygon& convex, const Vec3& normal, const Vec3& place) {
    for (std::size_t k = 0; k < convex.size(); ++k) {
        const Vec3 side = convex[(k + 1) % convex.size()] - convex[k];
        if (glm::dot(glm::cross(side, place - convex[k]), normal) < 0.0) return false;
    }
    return true;
}

double distance_to(const Ray& ray, const Polygon& convex, const CutPlanes& planes) {
    const Vec3 normal = unit_normal(convex);
    if (convex.size() < 3 || normal == Vec3(0.0)) return never;
    const double distance = distance_to_plane(ray, convex.front(), normal);
    if (distance == never) return never;
    const Vec3 place = ray.origin + distance * ray.direction;
    return planes.keeps(place) && inside(convex, normal, place) ? distance : never;
}

double distance_to(const Ray& ray, const Solid& solid, const CutPlanes& planes) {
    double nearest = never;
    for (const std::vector<int>& face : solid.faces) {
        Polygon outline;
        for (const int vertex : face) outline.push_back(solid.vertices[static_cast<std::size_t>(vertex)]);
        nearest = std::min(nearest, distance_to(ray, outline, planes));
    }
    return nearest;
}

/// Within the cell's box: most cells of a face are passed over by this.
bool near_cell(const DisplayMesh& display, const DisplayCell& cell, const Vec3& place) {
    constexpr double slack = 1e-6;  // m: boxes of cells are flat
    Vec3 low = display.vertices[cell.corner[0]].position, high = low;
    for (const std::uint32_t corner : cell.corner) {
        low = glm::min(low, display.vertices[corner].position);
        high = glm::max(high, display.vertices[corner].position);
    }
    return glm::all(glm::greaterThanEqual(place, low - slack)) && glm::all(glm::lessThanEqual(place, high + slack));
}

/// How near a segment comes to a picture position, in picture heights.
double distance_on_picture(const Camera& camera, Vec2 at, double aspect, const Vec3& from, const Vec3& to) {
    const auto start = projected(camera, from, aspect);
    const auto end = projected(camera, to, aspect);
    if (!start || !end) return never;
    const Vec2 stretch(aspect, 1.0);
    const Vec2 a = (*start - at) * stretch;
    const Vec2 along = (*end - *start) * stretch;
    const double length = glm::dot(along, along);
    const double nearest = length > 0.0 ? std::clamp(-glm::dot(a, along) / length, 0.0, 1.0) : 0.0;
    return glm::length(a + nearest * along);
}

struct Found {
    ObjectId object;
    double distance = never;
    void offer(ObjectId candidate, double at) {
        if (at < distance) *this = {candidate, at};
    }
};

class Pointer {
public:
    Pointer(const Scene& scene, const Camera& camera, Vec2 at, double aspect)
        : scene_(scene),
          camera_(camera),
          at_(at),
          aspect_(aspect),
          ray_(ray_through(camera, at, aspect)),
          planes_(camera.left_out, &scene) {}

    Found solids() const {
        Found found;
        for (const Solid& solid : solids_of(scene_)) found.offer(solid.object, distance_to(ray_, solid, planes_));
        for (const FreeSurface& surface : scene_.surfaces) {
            for (const Polygon& piece : convex_pieces(surface.region))
                found.offer(surface.id, distance_to(ray_, piece, planes_));
        }
        return found;
    }

    Found luminaires() const {
        Found found;
        for (const Luminaire& luminaire : scene_.luminaires)
            found.offer(luminaire.id, distance_to_luminaire(luminaire));
        return found;
    }

    Found points() const {
        Found found;
        for (const CalculationPoint& point : scene_.points) {
            if (planes_.keeps(point.position) && caught(point.position, point.position))
                found.offer(point.id, depth_of(point.position));
        }
        return found;
    }

    /// The nearest lit side of the room: what hangs outside of it is hidden.
    double wall() const {
        double nearest = never;
        for (const Face& face : faces_of(scene_)) {
            const bool of_room = scene_.room && face.ref.object == scene_.room->id;
            if (!of_room || glm::dot(face.normal, ray_.direction) >= 0.0) continue;
            for (const Polygon& piece : convex_pieces(face.region)) {
                nearest = std::min(nearest, distance_to(ray_, piece, planes_));
            }
        }
        return nearest;
    }

private:
    double depth_of(const Vec3& place) const { return glm::dot(place - ray_.origin, ray_.direction); }

    bool caught(const Vec3& from, const Vec3& to) const {
        return distance_on_picture(camera_, at_, aspect_, from, to) < catch_radius;
    }

    double distance_to_luminaire(const Luminaire& luminaire) const {
        if (!CutPlanes::is_kept(planes_.cut, luminaire.position)) return never;
        const LuminaireShape shape = shape_of(luminaire, scene_);
        double nearest = never;
        for (const Polygon& polygon : shape.shining) nearest = std::min(nearest, distance_to(ray_, polygon, {}));
        if (nearest < never) return nearest;
        for (const auto& [from, to] : shape.outline) {
            if (caught(from, to)) nearest = std::min(nearest, depth_of(0.5 * (from + to)));
        }
        if (shape.tube && caught(shape.tube->first, shape.tube->second)) {
            nearest = depth_of(0.5 * (shape.tube->first + shape.tube->second));
        }
        if (shape.point && caught(*shape.point, *shape.point)) nearest = depth_of(*shape.point);
        return nearest;
    }

    const Scene& scene_;
    const Camera& camera_;
    Vec2 at_;
    double aspect_;
    Ray ray_;
    CutPlanes planes_;
};

}  // namespace

std::optional<SurfaceHit> hit(const Solution& solution, const Ray& ray) {
    if (solution.display == nullptr || solution.mesh == nullptr) return std::nullopt;
    const DisplayMesh& display = *solution.display;
    const CutPlanes planes(ray.left_out, solution.scene.get());
    std::optional<SurfaceHit> nearest;
    for (std::uint32_t k = 0; k < display.cells.size(); ++k) {
        const DisplayCell& cell = display.cells[k];
        const Face& face = solution.mesh->faces[cell.face].face;
        if (glm::dot(face.normal, ray.direction) >= 0.0) continue;
        const double distance = distance_to_plane(ray, display.vertices[cell.corner[0]].position, face.normal);
        if (distance == never || (nearest && distance >= nearest->distance)) continue;
        const Vec3 place = ray.origin + distance * ray.direction;
        if (!planes.keeps(place) || !near_cell(display, cell, place)) continue;
        const CellFrame frame = frame_of(solution, cell);
        const Vec2 flat = frame.flat(place);
        if (!contains(frame, flat)) continue;
        const Vec2 at = glm::clamp(bilinear_coordinates(frame, flat), Vec2(0.0), Vec2(1.0));
        const auto value = [&](LightPart part) { return bilinear(corner_values(display, cell, part), at); };
        nearest = SurfaceHit{place,
                             face.normal,
                             distance,
                             cell.face,
                             k,
                             face.ref,
                             value(LightPart::direct),
                             value(LightPart::interreflected),
                             value(LightPart::unshadowed)};
    }
    if (nearest && planes.any() && solution.scene != nullptr &&
        meets_section(*solution.scene, planes, ray, nearest->distance))
        return std::nullopt;
    return nearest;
}

std::optional<FaceHit> first_face(const Scene& scene, const Ray& ray) {
    const CutPlanes planes(ray.left_out, &scene);
    std::optional<FaceHit> first;
    double nearest = never;
    for (const Face& face : faces_of(scene)) {
        if (glm::dot(face.normal, ray.direction) >= 0.0) continue;
        for (const Polygon& piece : convex_pieces(face.region)) {
            const double distance = distance_to(ray, piece, planes);
            if (distance >= nearest) continue;
            nearest = distance;
            first = FaceHit{ray.origin + distance * ray.direction, face.normal};
        }
    }
    return first;
}

ObjectId pick(const Scene& scene, const Camera& camera, Vec2 at, double aspect) {
    const Pointer pointer(scene, camera, at, aspect);
    const Found solid = pointer.solids();
    const double hidden_behind = std::min(solid.distance, pointer.wall()) + preferred_by;
    const Found point = pointer.points();
    if (point.object && point.distance <= hidden_behind) return point.object;
    const Found luminaire = pointer.luminaires();
    if (luminaire.object && luminaire.distance <= hidden_behind) return luminaire.object;
    return solid.distance <= pointer.wall() + preferred_by ? solid.object : ObjectId{};
}

}  // namespace hanei
