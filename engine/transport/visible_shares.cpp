#include "engine/transport/visible_shares.h"

#include "engine/geometry/visible_part.h"

#include <algorithm>
#include <cmath>

namespace hanei {

namespace {

/// For a receiver in the plane of a face: what it sees of patches is a limit, worked out one by one.
float limit_share(const Patch& patch, const Receiver& receiver, const OccluderSet& occluders,
                  std::span<const BodyIndex> bodies) {
    const double whole = configuration_factor(patch.outline, receiver);
    if (!(whole > 0.0)) return 1.0F;  // weighs nothing either way
    const double visible = visible_configuration_factor(patch.outline, receiver, occluders, bodies);
    return static_cast<float>(std::clamp(visible / whole, 0.0, 1.0));
}

Box box_of(std::span<const Receiver> receivers) {
    Box box{receivers[0].position, receivers[0].position};
    for (const Receiver& receiver : receivers) box.include(receiver.position);
    return box;
}

/// As many of the first receivers as lie in one plane, not too many.
std::size_t run_length(std::span<const Receiver> receivers, double same_place) {
    constexpr std::size_t most = 16;
    const Receiver& first = receivers[0];
    std::size_t count = 1;
    while (count < std::min(most, receivers.size())) {
        const Receiver& next = receivers[count];
        if (next.normal != first.normal) break;
        if (std::abs(glm::dot(next.position - first.position, first.normal)) > same_place) break;
        ++count;
    }
    return count;
}

}  // namespace

VisibleShares::VisibleShares(const Mesh& mesh, const OccluderSet& occluders)
    : mesh_(mesh),
      occluders_(occluders),
      layouts_(layouts_of(mesh)),
      cast_(mesh, occluders),
      likely_(layouts_.size(), 0) {
    faces_.reserve(layouts_.size());
    for (const FaceLayout& layout : layouts_) faces_.emplace_back(mesh, layout);
}

template <class WriteFace>
bool VisibleShares::for_each_run(std::span<const Receiver> side_by_side, float* shares, WriteFace&& write_face) {
    bool any = false;
    while (!side_by_side.empty()) {
        const std::size_t count = run_length(side_by_side, occluders_.same_place());
        const Run run{side_by_side.first(count), shares};
        cast_.start(run.receivers);
        any |= write_face(run);
        side_by_side = side_by_side.subspan(count);
        shares += count * mesh_.patches.size();
    }
    return any;
}

bool VisibleShares::write(std::span<const Receiver> side_by_side, float* shares) {
    if (occluders_.empty()) return false;
    return for_each_run(side_by_side, shares, [&](const Run& run) {
        bool any_hidden = false;
        for (std::size_t face = 0; face < layouts_.size(); ++face) any_hidden |= write_face(run, face);
        return any_hidden;
    });
}

bool VisibleShares::rewrite(std::span<const Receiver> side_by_side, const OccluderSet& changed, float* shares) {
    if (changed.empty()) return false;
    BodyShadows shadows(changed);
    return for_each_run(side_by_side, shares, [&](const Run& run) {
        shadows.start(run.receivers);
        bool any_changed = false;
        for (std::size_t face = 0; face < layouts_.size(); ++face) {
            any_changed |= rewrite_face(run, face, changed, shadows);
        }
        return any_changed;
    });
}

/// How each receiver sees the face. False when none does.
bool VisibleShares::look_at(const Run& run, const FaceLayout& layout) {
    seen_.clear();
    bool any_seen = false;
    for (const Receiver& receiver : run.receivers) {
        seen_.push_back(seen_from(layout, receiver));
        any_seen = any_seen || seen_.back() != FaceSeen::hidden;
    }
    return any_seen;
}

bool VisibleShares::write_face(const Run& run, std::size_t face) {
    const FaceLayout& layout = layouts_[face];
    if (!look_at(run, layout)) return false;
    if (likely_[face] < occluders_.bodies().size()) {
        before_.assign(1, likely_[face]);
        if (hidden_from_all(layout, run)) return true;
    }
    before_.clear();
    occluders_.between(box_of(run.receivers), layout.corners, before_);
    if (before_.empty()) return false;
    if (hidden_from_all(layout, run)) {
        likely_[face] = before_.front();
        return true;
    }
    bool any_hidden = false;
    cast_.next_face();
    for (std::size_t k = 0; k < run.receivers.size(); ++k) {
        if (seen_[k] == FaceSeen::hidden) continue;
        if (seen_[k] == FaceSeen::touching) {
            any_hidden |= write_limits(layout, run.receivers[k], row(run, k));
        } else {
            any_hidden |= cast_.write(faces_[face], k, before_, row(run, k));
        }
    }
    return any_hidden;
}

bool VisibleShares::rewrite_face(const Run& run, std::size_t face, const OccluderSet& changed, BodyShadows& shadows) {
    const FaceLayout& layout = layouts_[face];
    if (!look_at(run, layout)) return false;
    const Box eyes = box_of(run.receivers);
    changed_.clear();
    changed.between(eyes, layout.corners, changed_);
    if (changed_.empty()) return false;
    before_.clear();
    occluders_.between(eyes, layout.corners, before_);
    cast_.next_face();
    bool any_changed = false;
    for (std::size_t k = 0; k < run.receivers.size(); ++k) {
        if (seen_[k] == FaceSeen::hidden) continue;
        if (seen_[k] == FaceSeen::touching) {
            float* shares = row(run, k) + layout.face->first_patch;
            std::fill_n(shares, layout.face->patch_count, 1.0F);
            write_limits(layout, run.receivers[k], row(run, k));
            any_changed = true;
        } else if (cast_.find_shaded(faces_[face], k, shadows, changed_, shaded_)) {
            cast_.rewrite(faces_[face], k, before_, shaded_, row(run, k));
            any_changed = true;
        }
    }
    return any_changed;
}

/// Where one of the bodies before the face hides all of it from every receiver that faces it: then it
/// comes first among them, and the face's shares are written.
bool VisibleShares::hidden_from_all(const FaceLayout& layout, const Run& run) {
    constexpr double clearly = 4.0;  // so that no rounding shows a slit
    for (const BodyIndex body : before_) {
        const BodyShape& shape = occluders_.shape(body);
        bool hides = true;
        for (std::size_t k = 0; hides && k < run.receivers.size(); ++k) {
            if (seen_[k] == FaceSeen::hidden) continue;
            hides = hides_all(shape, run.receivers[k].position, layout.corners, clearly * occluders_.same_place());
        }
        if (!hides) continue;
        for (std::size_t k = 0; k < run.receivers.size(); ++k) {
            if (seen_[k] == FaceSeen::hidden) continue;
            std::fill_n(row(run, k) + layout.face->first_patch, layout.face->patch_count, 0.0F);
        }
        before_.assign(1, body);
        return true;
    }
    return false;
}

float* VisibleShares::row(const Run& run, std::size_t receiver) const {
    return run.shares + receiver * mesh_.patches.size();
}

bool VisibleShares::write_limits(const FaceLayout& layout, const Receiver& receiver, float* row) {
    bodies_.clear();
    occluders_.between(receiver.position, layout.corners, before_, bodies_);
    if (bodies_.empty()) return false;
    const MeshFace& face = *layout.face;
    for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p) {
        row[p] = limit_share(mesh_.patches[p], receiver, occluders_, bodies_);
    }
    return true;
}

}  // namespace hanei
