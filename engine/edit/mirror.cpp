#include "engine/edit/copies.h"
#include "engine/edit/luminaire_edits.h"
#include "engine/edit/with_object.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei {
namespace {

double whole_turns_off(double angle) { return std::remainder(angle, 2.0 * std::numbers::pi); }

void reverse_all(std::vector<std::vector<int>>& faces) {
    for (std::vector<int>& face : faces) std::reverse(face.begin(), face.end());
}

void mirror_x(std::vector<Vec3>& points) {
    for (Vec3& point : points) point.x = -point.x;
}

void mirror_x(Region& region) {
    mirror_x(region.outline);
    std::reverse(region.outline.begin(), region.outline.end());
    for (Polygon& hole : region.holes) {
        mirror_x(hole);
        std::reverse(hole.begin(), hole.end());
    }
}

/// In the furniture's frame: x changes its sign.
Part mirrored_part(Part part) {
    part.position.x = -part.position.x;
    part.rotation = -part.rotation;
    if (auto* const solid = std::get_if<SolidShape>(&part.shape)) {
        mirror_x(solid->vertices);
        reverse_all(solid->faces);
    }
    return part;
}

bool alike(const Part& a, const Part& b) {
    constexpr double same = 1e-9;
    if (a.material != b.material || a.shape.index() != b.shape.index()) return false;
    if (const auto* const box = std::get_if<BoxShape>(&a.shape)) {
        const Vec3 apart = box->size - std::get<BoxShape>(b.shape).size;
        return glm::length(apart) < same && glm::distance(a.position, b.position) < same &&
               std::abs(a.rotation - b.rotation) < same;
    }
    // Solids by their corners, in whatever order: the same corners enclose the same convex solid.
    const auto& first = std::get<SolidShape>(a.shape).vertices;
    const auto& second = std::get<SolidShape>(b.shape).vertices;
    return first.size() == second.size() && a.rotation == 0.0 && b.rotation == 0.0 &&
           std::all_of(first.begin(), first.end(), [&](const Vec3& corner) {
               return std::any_of(second.begin(), second.end(), [&](const Vec3& other) {
                   return glm::distance(corner + a.position, other + b.position) < same;
               });
           });
}

bool is_symmetric(const std::vector<Part>& parts, const std::vector<Part>& images) {
    return std::all_of(images.begin(), images.end(), [&](const Part& image) {
        return std::any_of(parts.begin(), parts.end(), [&](const Part& part) { return alike(part, image); });
    });
}

/// About planes of the scene: y mirrored is x mirrored and turned by half.
struct Mirror {
    MirrorAxis axis;
    double at;
    const Scene& scene;

    int coordinate() const { return axis == MirrorAxis::x ? 0 : 1; }
    Vec3 place(Vec3 from) const {
        from[coordinate()] = 2.0 * at - from[coordinate()];
        return from;
    }
    Vec3 direction(Vec3 from) const {
        from[coordinate()] = -from[coordinate()];
        return from;
    }
    double angle(double from) const {
        return whole_turns_off(axis == MirrorAxis::x ? -from : std::numbers::pi - from);
    }

    void operator()(Furniture& furniture) const {
        furniture.position = place(furniture.position);
        furniture.rotation = angle(furniture.rotation);
        std::vector<Part> images;
        for (const Part& part : furniture.parts) images.push_back(mirrored_part(part));
        if (is_symmetric(furniture.parts, images)) return;
        furniture.parts = std::move(images);
        furniture.model = {};
    }
    void operator()(FreeSurface& surface) const {
        for (Vec3& corner : surface.region.outline) corner = place(corner);
        std::reverse(surface.region.outline.begin(), surface.region.outline.end());
        for (Polygon& hole : surface.region.holes) {
            for (Vec3& corner : hole) corner = place(corner);
            std::reverse(hole.begin(), hole.end());
        }
    }
    /// Rz(yaw) Ry(-tilt) Rx(roll) between two mirrors in x is Rz(-yaw) Ry(tilt) Rx(roll); with the light
    /// symmetric about C0 rather than C90 the luminaire is turned by half about its own axis as well.
    void operator()(Luminaire& luminaire) const {
        luminaire.position = place(luminaire.position);
        luminaire.yaw = angle(luminaire.yaw);
        const Photometry* const photometry = photometry_of(scene, luminaire);
        const bool about_c0 = photometry != nullptr && photometry->symmetry == PhotometricSymmetry::plane_0;
        if (about_c0 && std::holds_alternative<MeasuredOpening>(luminaire.opening)) {
            luminaire.yaw = whole_turns_off(luminaire.yaw + std::numbers::pi);
            luminaire.roll = -luminaire.roll;
            return;
        }
        luminaire.tilt = -luminaire.tilt;
        if (auto* const line = std::get_if<LineOpening>(&luminaire.opening)) {
            line->from.x = -line->from.x;
            line->to.x = -line->to.x;
        } else if (auto* const polygon = std::get_if<PolygonOpening>(&luminaire.opening)) {
            mirror_x(polygon->region);
        } else if (auto* const solid = std::get_if<PolyhedronOpening>(&luminaire.opening)) {
            mirror_x(solid->vertices);
            reverse_all(solid->faces);
        }
    }
    /// The sides change places of their ends, so that the grid is lit from the same side.
    void operator()(CalculationGrid& grid) const {
        grid.corner = place(grid.corner + grid.along);
        grid.along = -direction(grid.along);
        grid.across = direction(grid.across);
    }
    void operator()(CalculationPoint& point) const {
        point.position = place(point.position);
        point.normal = direction(point.normal);
    }
};

}  // namespace

Scene mirrored(Scene scene, std::span<const ObjectId> chosen, MirrorAxis axis, double at) {
    const ObjectIds objects = objects_of(scene, chosen);
    // Arrangements whose luminaires go elsewhere one by one no longer say where they hang.
    for (const ObjectId id : objects)
        for (Arrangement& arrangement : scene.arrangements)
            std::replace(arrangement.luminaires.begin(), arrangement.luminaires.end(), id, ObjectId{});
    std::erase_if(scene.arrangements, [](const Arrangement& arrangement) {
        return std::none_of(arrangement.luminaires.begin(), arrangement.luminaires.end(),
                            [](ObjectId luminaire) { return static_cast<bool>(luminaire); });
    });
    const Scene before = scene;
    for (const ObjectId id : objects)
        with_object(scene, id, [&](auto& object, ObjectKind) {
            if constexpr (requires(const Mirror& mirror) { mirror(object); }) Mirror{axis, at, before}(object);
        });
    return scene;
}

}  // namespace hanei
