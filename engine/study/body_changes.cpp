#include "engine/study/body_changes.h"

#include <algorithm>
#include <iterator>
#include <tuple>

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

}  // namespace

BodyChanges body_changes(const OccluderSet& was, const OccluderSet& is) {
    const std::vector<ConvexBody> old_bodies = sorted(was.bodies()), new_bodies = sorted(is.bodies());
    BodyChanges changes{difference(old_bodies, new_bodies), difference(new_bodies, old_bodies)};
    changes.most = changes.gone.bodies().size() + changes.come.bodies().size() > is.bodies().size();
    return changes;
}

const BodyChanges& LastBodyChanges::between(const std::shared_ptr<const OccluderSet>& was,
                                            const std::shared_ptr<const OccluderSet>& is) {
    if (was_ != was || is_ != is) {
        changes_ = body_changes(*was, *is);
        was_ = was;
        is_ = is;
    }
    return changes_;
}

}  // namespace hanei
