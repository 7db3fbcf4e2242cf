#include "engine/base/tolerance.h"
#include "engine/geometry/polygon.h"
#include "engine/scene/faces.h"
#include "engine/scene/hard_pairs.h"
#include "engine/scene/placement.h"
#include "engine/scene/scene_findings.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

constexpr double close = 1e-2;     // distance from a source, of the source's size
constexpr double near_by = 1e-3;   // m: what programs set rays off a surface by
constexpr double facing = 0.99;    // cosine, of a normal along another
constexpr double same_side = 0.1;  // of the source's size: how far past a horizon counts

/// Something that shines: a flat outline, or a line of two ends.
struct Source {
    Polygon outline;
    std::string name;
    bool is_line() const { return outline.size() == 2; }
};

std::vector<Source> sources_of(const Scene& scene) {
    std::vector<Source> sources;
    for (const FreeSurface& sheet : scene.surfaces)
        if (sheet.own_exitance.value > 0.0) sources.push_back({sheet.region.outline, sheet.name});
    for (const Luminaire& luminaire : scene.luminaires) {
        const Placement placed = placement(luminaire);
        const auto add = [&](const std::vector<Vec3>& places) {
            Source source{{}, luminaire.name};
            for (const Vec3& place : places) source.outline.push_back(placed.point(place));
            sources.push_back(std::move(source));
        };
        if (const auto* const polygon = std::get_if<PolygonOpening>(&luminaire.opening)) add(polygon->region.outline);
        if (const auto* const line = std::get_if<LineOpening>(&luminaire.opening)) add({line->from, line->to});
        if (const auto* const solid = std::get_if<PolyhedronOpening>(&luminaire.opening))
            for (const std::vector<int>& face : solid->faces) {
                std::vector<Vec3> loop;
                for (const int vertex : face) loop.push_back(solid->vertices[static_cast<std::size_t>(vertex)]);
                add(loop);
            }
    }
    return sources;
}

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const double length2 = glm::dot(b - a, b - a);
    const double along = length2 > 0.0 ? std::clamp(glm::dot(p - a, b - a) / length2, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + along * (b - a));
}

double distance_to_outline(const Vec3& p, const Polygon& outline) {
    double nearest = HUGE_VAL;
    for (std::size_t k = 0; k < outline.size(); ++k)
        nearest = std::min(nearest, distance_to_segment(p, outline[k], outline[(k + 1) % outline.size()]));
    return nearest;
}

/// Is the foot of the perpendicular from p inside the outline?
bool is_before(const Vec3& p, const Polygon& outline, const Vec3& normal) {
    double turned = 0.0;  // the angle that the outline runs round the perpendicular
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vec3 a = outline[k] - p, b = outline[(k + 1) % outline.size()] - p;
        const Vec3 flat_a = a - normal * glm::dot(a, normal), flat_b = b - normal * glm::dot(b, normal);
        turned += std::atan2(glm::dot(glm::cross(flat_a, flat_b), normal), glm::dot(flat_a, flat_b));
    }
    return std::abs(turned) > 3.0;
}

double distance_to(const Vec3& p, const Polygon& outline) {
    const Vec3 normal = unit_normal(outline);
    const double height = std::abs(glm::dot(p - outline.front(), normal));
    return is_before(p, outline, normal) ? height : distance_to_outline(p, outline);
}

class PointSpots {
public:
    PointSpots(HardSpots& spots, std::size_t index) : spots_(spots), index_(index), point_(spots.scene.points[index]) {}

    void look_at(const Source& source) {
        const double size = diameter(source.outline);
        if (size <= 0.0) return;
        if (source.is_line()) return look_at_line(source, size);
        const Plane plane{source.outline.front(), unit_normal(source.outline)};
        const double height = std::abs(plane.height(point_.position));
        const double distance = distance_to(point_.position, source.outline);
        if (height <= tolerance::touching * spots_.size) {
            if (distance > 0.0 || glm::dot(point_.normal, plane.normal) < facing)  // else it lies on what shines
                note("it lies in the plane of \"" + source.name +
                     "\", where light jumps between all and nothing; it is told the limit from one side. Move it off "
                     "the plane to choose the side");
            return;
        }
        keep_if_close(source, distance, size);
        const double middle = height_above_horizon(centroid(source.outline));
        double highest = -HUGE_VAL;
        for (const Vec3& corner : source.outline) highest = std::max(highest, height_above_horizon(corner));
        if (distance > close * size && middle < -spots_.thickness && highest > same_side * size)
            note("the middle of \"" + source.name +
                 "\" lies behind it and a part before it; a ray to the middle finds nothing. The part before it is cut "
                 "out exactly here; nothing needs to be done");
    }

    /// Of all sources that it is close to the one that is closest for its size.
    void tell_closest() const {
        if (size_ <= 0.0) return;
        const std::string length = distance_ < 0.1 ? figure(1000.0 * distance_) + " mm" : figure(distance_) + " m";
        note("it lies " + length + " from \"" + closest_ +
             "\", a hundredth of its size or less; the inverse square law from its middle would be far off. The closed "
             "form used here holds at any distance; nothing needs to be done");
    }

    void look_at_sheets() const {
        for (const FreeSurface& sheet : spots_.scene.surfaces) {
            if (distance_to(point_.position, sheet.region.outline) > spots_.thickness) continue;
            if (glm::dot(point_.normal, unit_normal(sheet.region.outline)) < -facing)
                return note("it lies on the back of the sheet \"" + sheet.name +
                            "\", which is in the same place as its front; by distance nobody can tell them apart. Its "
                            "normal does here; turn it round if you mean the front");
        }
    }

    void look_at_room(const std::vector<Plane>& planes) const {
        const auto faces = std::count_if(planes.begin(), planes.end(), [&](const Plane& plane) {
            return std::abs(plane.height(point_.position)) <= spots_.thickness;
        });
        if (faces >= 2)
            note("it lies in " + std::to_string(faces) +
                 " faces of the room at once; form factors from point to point burst there. Its normal says which face "
                 "is meant, and form factors of whole patches are used; nothing needs to be done");
    }

    /// A lamp without extent: in its very place, and by the edge of a shadow without a penumbra.
    void look_at_lamp(const Luminaire& lamp, const std::vector<Shell>& shells) const {
        if (glm::distance(lamp.position, point_.position) <= spots_.thickness)
            return note("it is where \"" + lamp.name +
                        "\" is, a lamp without extent; light there has no bound and no direction. It is told 0 lx; "
                        "move it");
        for (const Shell& shell : shells)
            for (const std::vector<int>& face : shell.faces)
                for (std::size_t k = 0; k < face.size(); ++k) {
                    const Vec3& a = shell.vertices[static_cast<std::size_t>(face[k])];
                    const Vec3& b = shell.vertices[static_cast<std::size_t>(face[(k + 1) % face.size()])];
                    if (passes_by(lamp.position, a, b))
                        return note("light of \"" + lamp.name +
                                    "\" passes an edge within a millimetre on its way to it, and a lamp without extent "
                                    "has no penumbra; a ray that is set off by so much tells the wrong side. The edge "
                                    "is where it is here; give the lamp its size, or move the point");
                }
    }

private:
    double height_above_horizon(const Vec3& place) const { return glm::dot(place - point_.position, point_.normal); }

    void look_at_line(const Source& source, double size) {
        const Vec3 along = (source.outline[1] - source.outline[0]) / size;
        const Vec3 from = point_.position - source.outline[0];
        if (glm::length(from - along * glm::dot(from, along)) <= tolerance::touching * spots_.size)
            return note("it lies in line with \"" + source.name +
                        "\", which sends nothing that way; beside the line light has no bound. It is told 0 lx; move "
                        "it aside");
        keep_if_close(source, distance_to_segment(point_.position, source.outline[0], source.outline[1]), size);
    }

    void keep_if_close(const Source& source, double distance, double size) {
        if (distance >= close * size || (size_ > 0.0 && distance / size >= distance_ / size_)) return;
        closest_ = source.name;
        distance_ = distance;
        size_ = size;
    }

    /// Does the segment from the lamp to the point come near the edge, away from both its own ends?
    bool passes_by(const Vec3& lamp, const Vec3& a, const Vec3& b) const {
        const Vec3 way = point_.position - lamp, edge = b - a;
        const Vec3 across = glm::cross(way, edge);
        const double way2 = glm::dot(way, way), across2 = glm::dot(across, across);
        if (across2 <= tolerance::parallel * way2 * glm::dot(edge, edge)) return false;
        const double on_way = glm::dot(glm::cross(a - lamp, edge), across) / across2;
        const double on_edge = glm::dot(glm::cross(a - lamp, way), across) / across2;
        const double apart = std::abs(glm::dot(a - lamp, across)) / std::sqrt(across2);
        const double short_of = near_by / std::sqrt(way2);
        return apart < near_by && on_way > short_of && on_way < 1.0 - short_of && on_edge >= 0.0 && on_edge <= 1.0;
    }

    void note(const std::string& message) const {
        spots_.note("points", index_, "point", point_.name, point_.id, "position", message);
    }

    HardSpots& spots_;
    std::size_t index_;
    const CalculationPoint& point_;
    std::string closest_;                 ///< name of the source
    double distance_ = 0.0, size_ = 0.0;  ///< m; a size of 0: it is close to none
};

}  // namespace

void look_at_points(HardSpots& spots, const std::vector<Plane>& room) {
    const std::vector<Source> sources = sources_of(spots.scene);
    const std::vector<Shell> shells = shells_of(spots.scene);
    for (std::size_t i = 0; i < spots.scene.points.size(); ++i) {
        PointSpots point(spots, i);
        for (const Source& source : sources) point.look_at(source);
        point.tell_closest();
        point.look_at_sheets();
        point.look_at_room(room);
        for (const Luminaire& lamp : spots.scene.luminaires)
            if (std::holds_alternative<PointOpening>(lamp.opening)) point.look_at_lamp(lamp, shells);
    }
}

}  // namespace hanei
