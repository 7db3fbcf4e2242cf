#include "engine/transport/visible_shares.h"

#include "engine/geometry/visible_part.h"

#include <algorithm>

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

}  // namespace

VisibleShares::VisibleShares(const Mesh& mesh, const OccluderSet& occluders)
    : mesh_(mesh),
      occluders_(occluders),
      layouts_(layouts_of(mesh)),
      cast_(mesh, occluders),
      known_for_(layouts_.size(), 0),
      known_(layouts_.size()) {}

bool VisibleShares::write(std::span<const Receiver> side_by_side, float* shares) {
    const ColumnRange all{0, mesh_.patches.size()};
    return write(side_by_side, std::span(&all, 1), shares);
}

bool VisibleShares::write(std::span<const Receiver> side_by_side, std::span<const ColumnRange> patches, float* shares) {
    if (side_by_side.empty() || occluders_.empty()) return false;
    eyes_ = box_of(side_by_side);
    ++tile_;
    bool any_hidden = false;
    for (std::size_t k = 0; k < side_by_side.size(); ++k) {
        cast_.start(side_by_side[k]);
        float* row = shares + k * mesh_.patches.size();
        auto range = patches.begin();
        for (std::size_t face = 0; face < layouts_.size(); ++face) {
            const std::size_t first = layouts_[face].face->first_patch;
            while (range != patches.end() && range->last <= first) ++range;
            if (range == patches.end()) break;
            if (range->first <= first) any_hidden |= write_face(face, side_by_side[k], row);
        }
    }
    return any_hidden;
}

void VisibleShares::touched_by(const OccluderSet& gone, const OccluderSet& come, std::span<const Receiver> side_by_side,
                               std::vector<ColumnRange>& found) const {
    if (side_by_side.empty()) return;
    const Box eyes = box_of(side_by_side);
    std::vector<BodyIndex> bodies;
    for (const FaceLayout& layout : layouts_) {
        bodies.clear();
        gone.between(eyes, layout.corners, bodies);
        if (bodies.empty()) come.between(eyes, layout.corners, bodies);
        if (bodies.empty()) continue;
        const std::size_t first = layout.face->first_patch;
        found.push_back({first, first + layout.face->patch_count});
    }
}

std::span<const BodyIndex> VisibleShares::bodies_before(std::size_t face) {
    if (known_for_[face] != tile_) {
        known_[face].clear();
        occluders_.between(eyes_, layouts_[face].corners, known_[face]);
        known_for_[face] = tile_;
    }
    return known_[face];
}

bool VisibleShares::write_face(std::size_t face, const Receiver& receiver, float* row) {
    const FaceLayout& layout = layouts_[face];
    const FaceSeen seen = seen_from(layout, receiver);
    if (seen == FaceSeen::hidden) return false;
    bodies_.clear();
    occluders_.between(receiver.position, layout.corners, bodies_before(face), bodies_);
    if (bodies_.empty()) return false;
    if (seen == FaceSeen::touching) {
        write_limits(*layout.face, receiver, row);
    } else {
        cast_.write(layout, bodies_, row);
    }
    return true;
}

void VisibleShares::write_limits(const MeshFace& face, const Receiver& receiver, float* row) const {
    for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p) {
        row[p] = limit_share(mesh_.patches[p], receiver, occluders_, bodies_);
    }
}

}  // namespace hanei
