#include "engine/direct/diffuse_source.h"

#include "engine/geometry/polygon.h"
#include "engine/geometry/visible_part.h"

#include <algorithm>
#include <numeric>

namespace hanei {

namespace {

ConvexBody sheet(const Polygon& outline) {
    std::vector<int> loop(outline.size());
    std::iota(loop.begin(), loop.end(), 0);
    return {outline, {std::move(loop)}, 0};
}

}  // namespace

DiffuseSource::DiffuseSource(std::vector<LuminousFace> faces, bool hide_each_other) {
    std::vector<ConvexBody> sheets;
    for (LuminousFace& luminous : faces) {
        std::vector<Polygon> pieces = convex_pieces(luminous.region);
        if (hide_each_other) std::ranges::transform(pieces, std::back_inserter(sheets), sheet);
        const Vec3 front = unit_normal(luminous.region.outline);
        if (!pieces.empty()) faces_.push_back({std::move(luminous), std::move(pieces), front});
    }
    own_ = OccluderSet(std::move(sheets));
}

std::vector<Vec3> DiffuseSource::extent() const {
    std::vector<Vec3> corners;
    for (const Face& face : faces_) {
        const Polygon& outline = face.luminous.region.outline;
        corners.insert(corners.end(), outline.begin(), outline.end());
    }
    return corners;
}

bool DiffuseSource::may_light(const Face& face, const Receiver& receiver) const {
    const Polygon& outline = face.luminous.region.outline;
    const Vec3 away = receiver.position - outline[0];
    // In or near the face's plane the form factor itself decides.
    if (glm::dot(away, face.front) < -1e-6 * glm::length(away)) return false;
    return face.luminous.exitance > 0.0 && std::ranges::any_of(outline, [&](const Vec3& corner) {
               return glm::dot(corner - receiver.position, receiver.normal) > 0.0;
           });
}

double DiffuseSource::unobstructed(const Receiver& receiver) const { return obstructed(receiver, Obstacles{}); }

double DiffuseSource::obstructed(const Receiver& receiver, const Obstacles& obstacles) const {
    thread_local std::vector<BodyIndex> others, own;
    const OccluderSet& occluders = obstacles.occluders ? *obstacles.occluders : own_;
    double sum = 0.0;
    for (const Face& face : faces_) {
        if (!may_light(face, receiver)) continue;
        const Region& region = face.luminous.region;
        obstacles.between(receiver.position, region.outline, others);
        own.clear();
        own_.between(receiver.position, region.outline, own);
        double factor = 0.0;
        if (others.empty() && own.empty()) {
            factor = configuration_factor(region, receiver);
        } else if (own.empty()) {
            for (const Polygon& piece : face.pieces) {
                factor += visible_configuration_factor(piece, receiver, occluders, others);
            }
        } else {
            for (const Polygon& piece : face.pieces) {
                for (const Polygon& part : visible_part(piece, receiver.position, own_, own)) {
                    factor += visible_configuration_factor(part, receiver, occluders, others);
                }
            }
        }
        sum += face.luminous.exitance * factor;
    }
    return sum;
}

}  // namespace hanei
