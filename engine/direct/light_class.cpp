#include "engine/direct/light_class.h"

#include "engine/base/tiles.h"
#include "engine/base/tolerance.h"
#include "engine/direct/shadow_proof.h"
#include "engine/direct/sight_hull.h"
#include "engine/geometry/polygon.h"

#include <algorithm>
#include <cmath>

namespace hanei {

namespace {

double greatest_height(const Plane& plane, std::span<const Vec3> points) {
    double greatest = plane.height(points[0]);
    for (const Vec3& point : points) greatest = std::max(greatest, plane.height(point));
    return greatest;
}

double least_height(const Plane& plane, std::span<const Vec3> points) {
    return -greatest_height({plane.point, -plane.normal}, points);
}

/// The part of a polygon, line or point in front of a plane; the whole when nothing is behind.
Polygon front_part(const Polygon& whole, const Plane& plane, double thickness) {
    if (least_height(plane, whole) >= -thickness) return whole;
    if (whole.size() != 2) return clipped(whole, plane, thickness);
    const double start = plane.height(whole[0]), end = plane.height(whole[1]);
    const Vec3 crossing = whole[0] + (start / (start - end)) * (whole[1] - whole[0]);
    return start > 0.0 ? Polygon{whole[0], crossing} : Polygon{crossing, whole[1]};
}

/// A patch and a piece of an opening: the parts of both that face each other.
struct Facing {
    Polygon patch, opening;
};

std::optional<Facing> facing_parts(const ReceivingPolygon& patch, const LuminousPiece& piece) {
    const Plane horizon{patch.outline[0], patch.normal};
    const double reach =
        glm::length(piece.corners[0] - patch.outline[0]) + diameter(piece.corners) + diameter(patch.outline);
    const double touching = tolerance::touching * reach;
    // A patch in the opening's own plane and turned to it lies in the light itself: no case of `away`.
    const bool may_coincide = glm::dot(piece.front, patch.normal) < -0.9;
    if (greatest_height(horizon, piece.corners) <= (may_coincide ? -touching : touching)) return std::nullopt;
    Facing facing{{patch.outline.begin(), patch.outline.end()}, front_part(piece.corners, horizon, touching)};
    if (piece.front != Vec3{0.0}) {
        Plane front{piece.corners[0], piece.front};
        for (const Vec3& corner : piece.corners) {
            if (front.height(corner) < 0.0) front.point = corner;
        }
        if (greatest_height(front, facing.patch) <= (may_coincide ? -touching : touching)) return std::nullopt;
        facing.patch = front_part(facing.patch, front, touching);
    }
    // Cut to nothing by rounding: what is left is the border of both. The uncut are a safe superset.
    if (facing.patch.empty()) facing.patch.assign(patch.outline.begin(), patch.outline.end());
    if (facing.opening.empty()) facing.opening = piece.corners;
    return facing;
}

/// The facing parts and the bodies that may stand between them.
class Case {
public:
    Case(const Facing& facing, const OccluderSet& occluders, std::vector<BodyIndex>& found)
        : question_{facing.patch, facing.opening, occluders, {}}, found_(found), hull_(facing.patch, facing.opening) {}

    /// Leaves in `found` the bodies that stand in some sight line, or a few more.
    LightClass kind(int halvings) {
        question_.among = found_;
        if (is_hidden_by_one(question_)) return LightClass::umbra;
        const double touching = question_.occluders.same_place();
        std::erase_if(found_,
                      [&](BodyIndex body) { return hull_.is_soon_clear_of(shape(body), vertices(body), touching); });
        // One body surely in the way decides; those after it are not worth the whole test.
        while (!found_.empty() && hull_.edges_separate(shape(found_.back()), vertices(found_.back()), touching))
            found_.pop_back();
        if (found_.empty()) return LightClass::lit;
        if (halvings == ClassEffort::single_bodies) return LightClass::partly;
        question_.among = found_;
        return is_hidden_by_several(question_, halvings) ? LightClass::umbra : LightClass::partly;
    }

private:
    const BodyShape& shape(BodyIndex body) const { return question_.occluders.shape(body); }
    std::span<const Vec3> vertices(BodyIndex body) const { return question_.occluders.bodies()[body].vertices; }

    SightQuestion question_;
    std::vector<BodyIndex>& found_;
    SightHull hull_;
};

}  // namespace

LightClass classify(const ReceivingPolygon& patch, const Emitter& emitter, const OccluderSet* occluders,
                    const std::optional<std::span<const BodyIndex>>& among, std::vector<BodyIndex>& between,
                    const ClassEffort& effort) {
    between.clear();
    LightClass whole = LightClass::away;
    if (patch.outline.size() < 3) return whole;
    std::vector<BodyIndex> found;
    const std::uint32_t own_body = emitter.luminaire().value;
    for (const LuminousPiece& piece : emitter.pieces()) {
        const std::optional<Facing> facing = facing_parts(patch, piece);
        if (!facing) continue;
        LightClass kind = LightClass::lit;
        if (occluders) {
            found.clear();
            if (among)
                found.assign(among->begin(), among->end());
            else
                occluders->between(facing->patch, facing->opening, found);
            std::erase_if(found, [&](BodyIndex body) { return occluders->bodies()[body].owner == own_body; });
            kind = Case(*facing, *occluders, found).kind(effort.halvings);
            between.insert(between.end(), found.begin(), found.end());
        }
        whole = together(whole, kind);
    }
    if (whole != LightClass::partly) between.clear();
    std::ranges::sort(between);
    between.erase(std::ranges::unique(between).begin(), between.end());
    return whole;
}

std::optional<std::vector<LightClass>> light_classes(std::span<const ReceivingPolygon> patches, const Emitter& emitter,
                                                     const OccluderSet* occluders, const Work& work) {
    std::vector<LightClass> classes(patches.size());
    const bool finished = for_each_tile(patches.size(), 16, work, [&](std::size_t begin, std::size_t end) {
        std::vector<BodyIndex> between;
        for (std::size_t k = begin; k < end; ++k)
            classes[k] = classify(patches[k], emitter, occluders, std::nullopt, between, {3});
    });
    if (!finished) return std::nullopt;
    return classes;
}

}  // namespace hanei
