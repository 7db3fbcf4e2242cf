#include "engine/direct/shadow_outline.h"

#include "engine/direct/facing_parts.h"
#include "engine/direct/flat_regions.h"
#include "engine/direct/shadow_volume.h"

#include <algorithm>

namespace hanei {

namespace {

/// The parts of a face's surroundings and of the opening's pieces that face each other.
std::vector<FacingParts> facing_pairs(const Polygon& around, const Vec3& normal, const Emitter& emitter) {
    std::vector<FacingParts> pairs;
    for (const LuminousPiece& piece : emitter.pieces()) {
        if (auto facing = facing_parts({around, normal}, piece)) pairs.push_back(std::move(*facing));
    }
    return pairs;
}

/// Every place of the pairs' openings once.
std::vector<Vec3> corners_of(const std::vector<FacingParts>& pairs) {
    std::vector<Vec3> corners;
    for (const FacingParts& pair : pairs) {
        for (const Vec3& corner : pair.opening) {
            if (std::ranges::find(corners, corner) == corners.end()) corners.push_back(corner);
        }
    }
    return corners;
}

/// What of the polygon lies behind all planes.
Polygon behind_all(Polygon polygon, std::span<const Plane> planes) {
    for (const Plane& plane : planes) {
        if (polygon.empty()) break;
        polygon = clipped(polygon, {plane.point, -plane.normal}, 0.0);
    }
    return polygon;
}

/// Shadows of single bodies, before they are united.
struct Casting {
    const FlatRegions& plane;
    const OccluderSet& occluders;
    ClipperLib::Paths umbra, penumbra;

    void add_penumbra(BodyIndex body, const FacingParts& pair) {
        const Polygon shadow = behind_all(pair.patch, planes_from(body, pair.opening));
        if (!shadow.empty()) penumbra.push_back(plane.flat(shadow));
    }
    void add_umbra(BodyIndex body, const FacingParts& pair, std::span<const Vec3> corners) {
        Polygon shadow = pair.patch;
        for (const Vec3& corner : corners) {
            if (shadow.empty()) return;
            shadow = behind_all(std::move(shadow), planes_from(body, {&corner, 1}));
        }
        if (!shadow.empty()) umbra.push_back(plane.flat(shadow));
    }
    std::vector<Plane> planes_from(BodyIndex body, std::span<const Vec3> source) const {
        return shadow_planes(occluders.shape(body), occluders.bodies()[body].vertices, source, occluders.same_place());
    }
};

/// True when something of the body rises before the face.
bool rises_before(const ConvexBody& body, const Face& face, double same_place) {
    const Plane plane{face.region.outline[0], face.normal};
    return std::ranges::any_of(body.vertices, [&](const Vec3& vertex) { return plane.height(vertex) > same_place; });
}

}  // namespace

FaceShadows shadows_on(const Face& face, std::span<const Polygon> covers, const Emitter& emitter,
                       const OccluderSet& occluders) {
    const FlatRegions plane(face);
    const std::vector<FacingParts> pairs = facing_pairs(plane.around(), face.normal, emitter);
    const std::vector<Vec3> corners = corners_of(pairs);
    Casting casting{plane, occluders, {}, {}};
    std::vector<BodyIndex> between;
    for (const FacingParts& pair : pairs) {
        between.clear();
        occluders.between(face.region.outline, pair.opening, between);
        for (const BodyIndex body : between) {
            const ConvexBody& shape = occluders.bodies()[body];
            if (shape.owner == emitter.luminaire().value || occluders.shape(body).faces.empty()) continue;
            if (!rises_before(shape, face, occluders.same_place())) continue;
            casting.add_penumbra(body, pair);
            casting.add_umbra(body, pair, corners);
        }
    }
    if (casting.penumbra.empty()) return {};
    const ClipperLib::Paths bare = plane.face_without(covers);
    const ClipperLib::Paths umbra = united(casting.umbra), penumbra = united(casting.penumbra);
    return {plane.in_space(common(umbra, bare)), plane.in_space(common(penumbra, bare)),
            plane.in_space(borders(umbra, bare)), plane.in_space(borders(penumbra, bare))};
}

}  // namespace hanei
