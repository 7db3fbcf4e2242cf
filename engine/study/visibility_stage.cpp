#include "engine/study/visibility_stage.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace hanei {

namespace {

bool place_before(const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

/// Some order in which equal bodies are neighbours.
bool body_before(const ConvexBody& a, const ConvexBody& b) {
    if (a.vertices != b.vertices)
        return std::lexicographical_compare(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(),
                                            place_before);
    return a.faces < b.faces;
}

std::vector<ConvexBody> sorted(std::span<const ConvexBody> bodies) {
    std::vector<ConvexBody> result(bodies.begin(), bodies.end());
    std::sort(result.begin(), result.end(), body_before);
    return result;
}

/// Bodies of `these` that are not among `those`.
OccluderSet difference(const std::vector<ConvexBody>& these, const std::vector<ConvexBody>& those) {
    std::vector<ConvexBody> only;
    std::set_difference(these.begin(), these.end(), those.begin(), those.end(), std::back_inserter(only), body_before);
    return OccluderSet(std::move(only));
}

std::optional<Visibility> brought_up_to_date(Visibility before, const Mesh& mesh, std::span<const Receiver> receivers,
                                             const OccluderSet& was, const OccluderSet& is, const Work& work) {
    const std::vector<ConvexBody> old_bodies = sorted(was.bodies()), new_bodies = sorted(is.bodies());
    const OccluderSet gone = difference(old_bodies, new_bodies), come = difference(new_bodies, old_bodies);
    // When most bodies moved, asking what they touched costs more than it saves.
    if (gone.bodies().size() + come.bodies().size() > is.bodies().size())
        return patch_visibility(mesh, receivers, is, work);
    return updated_visibility(std::move(before), mesh, receivers, gone, come, is, work);
}

}  // namespace

const Visibility* VisibilityStage::get(const Rows& rows, const Mesh& mesh, std::span<const Receiver> receivers,
                                       const std::shared_ptr<const OccluderSet>& occluders, const Work& work) {
    const bool same_rows = value_ && rows_ == rows;
    reused_ = same_rows && occluders_ == occluders;
    if (reused_) return &*value_;
    std::optional<Visibility> before = std::exchange(value_, std::nullopt);
    if (!occluders) {
        value_ = Visibility{};
    } else if (same_rows && occluders_) {
        value_ = brought_up_to_date(std::move(*before), mesh, receivers, *occluders_, *occluders, work);
    } else {
        value_ = patch_visibility(mesh, receivers, *occluders, work);
    }
    rows_ = rows;
    occluders_ = occluders;
    return value_ ? &*value_ : nullptr;
}

}  // namespace hanei
