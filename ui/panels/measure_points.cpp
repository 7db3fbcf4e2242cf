#include "ui/panels/measure_points.h"

#include "engine/edit/edit.h"
#include "engine/edit/several.h"
#include "ui/panels/drag.h"
#include "ui/view/pick.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

bool is_left_out(const LeftOut& left_out, const Vec3& place) {
    return left_out.cut && glm::dot(left_out.cut->normal, place) > left_out.cut->offset + 1e-9;
}

double depth_of(const Pane& pane, const Vec3& place) {
    return glm::dot(place - pane.camera.eye, axes_of(pane.camera).forward);
}

/// Keeps the mark nearest to the pointer.
struct Nearest {
    const Pane& pane;
    ImVec2 at;
    float reach;
    std::optional<MeasurePoint> found{};
    double depth = 0.0;
    float away = 0.0F;

    void offer(const Vec3& place, Catch caught) {
        if (is_left_out(pane.camera.left_out, place)) return;
        const auto seen = pane.on_screen(place);
        if (!seen) return;
        const float off = std::hypot(seen->x - at.x, seen->y - at.y);
        if (off > reach) return;
        constexpr float one_place = 1.0F;  // pixels
        const double deep = depth_of(pane, place);
        const bool nearer = off < away - one_place || (off < away + one_place && deep < depth - 1e-9);
        if (found && !nearer) return;
        found = MeasurePoint{place, caught};
        depth = deep;
        away = off;
    }
};

/// The place on the edge that the pointer's ray passes nearest.
std::optional<Vec3> on_edge(const MeasureMarks::Edge& edge, const Ray& ray) {
    const Vec3 along = edge.to - edge.from;
    const double length = glm::length(along);
    if (!(length > 0.0)) return std::nullopt;
    const Vec3 unit = along / length, between = edge.from - ray.origin;
    const double cosine = glm::dot(unit, ray.direction), sine_squared = 1.0 - cosine * cosine;
    if (!(sine_squared > 1e-6)) return std::nullopt;  // seen end on: its corners are there
    const double by = (cosine * glm::dot(ray.direction, between) - glm::dot(unit, between)) / sine_squared;
    return edge.from + std::clamp(by, 0.0, length) * unit;
}

/// The raster's place nearest, in the face: along its normal nothing is moved.
Vec3 on_raster(const FaceHit& hit, double raster) {
    Vec3 place = hit.place;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(hit.normal[axis]) < 1e-6) place[axis] = snapped(place[axis], raster);
    }
    return place;
}

}  // namespace

MeasureMarks measure_marks(const Scene& scene) {
    MeasureMarks marks;
    const auto loop = [&](const Polygon& outline) {
        for (std::size_t k = 0; k < outline.size(); ++k) {
            marks.corners.push_back(outline[k]);
            marks.edges.push_back({outline[k], outline[(k + 1) % outline.size()]});
        }
    };
    for (const Face& face : faces_of(scene)) {
        loop(face.region.outline);
        for (const Polygon& hole : face.region.holes) loop(hole);
        for (const FaceArea& area : face.areas) loop(area.outline);
    }
    for (const Luminaire& luminaire : scene.luminaires) marks.centres.push_back(luminaire.position);
    for (const CalculationPoint& point : scene.points) marks.centres.push_back(point.position);
    for (const Furniture& furniture : scene.furniture) {
        const ObjectId ids[] = {furniture.id};
        if (const auto bounds = bounds_of_objects(scene, ids)) {
            const Vec3 middle = 0.5 * (bounds->low + bounds->high);
            marks.centres.emplace_back(middle.x, middle.y, bounds->high.z);
        }
    }
    return marks;
}

std::optional<MeasurePoint> measure_point(const Scene& scene, const MeasureMarks& marks, const Pane& pane, ImVec2 at,
                                          double raster, float reach, bool catches) {
    const Ray ray = pane.ray(at);
    if (catches) {
        Nearest points{pane, at, reach};
        for (const Vec3& corner : marks.corners) points.offer(corner, Catch::corner);
        for (const Vec3& centre : marks.centres) points.offer(centre, Catch::centre);
        if (points.found) return points.found;
        Nearest edges{pane, at, 0.7F * reach};
        for (const MeasureMarks::Edge& edge : marks.edges)
            if (const auto place = on_edge(edge, ray)) edges.offer(*place, Catch::edge);
        if (edges.found) return edges.found;
    }
    const std::optional<FaceHit> hit = first_face(scene, ray);
    if (!hit) return std::nullopt;
    if (!catches || !(raster > 0.0)) return MeasurePoint{hit->place, Catch::none};
    return MeasurePoint{on_raster(*hit, raster), Catch::raster};
}

}  // namespace hanei
