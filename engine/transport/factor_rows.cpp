#include "engine/transport/factor_rows.h"

#include "engine/base/check.h"
#include "engine/geometry/polygon.h"
#include "engine/transport/rectangle_kernel.h"

#include <algorithm>
#include <optional>

namespace hanei {

namespace {

void put_shares(const KernelMiddle& seen, float* columns) {
    const std::array<double, 4> shares = node_shares(seen);
    std::transform(shares.begin(), shares.end(), columns, [](double share) { return static_cast<float>(share); });
}

void put(const Nodes& nodes, const Polygon& outline, const PatchFrame& frame, const Receiver& receiver,
         float* columns) {
    if (nodes.elements == Elements::constant) {
        *columns = static_cast<float>(configuration_factor(outline, receiver));
        return;
    }
    put_shares(kernel_middle(outline, frame, receiver), columns);
}

/// The light of a rectangle that the horizon cuts along its sides, so that a rectangle is left; nothing
/// when it cuts otherwise.
std::optional<KernelMiddle> cut_rectangle(const Polygon& outline, const PatchFrame& frame, const Receiver& receiver) {
    const Polygon visible = clipped(outline, {receiver.position, receiver.normal}, 0.0);
    if (!is_rectangle(visible)) return std::nullopt;
    const PatchFrame left = frame_of(visible, unit_normal(visible), frame.along);
    const KernelMiddle seen = rectangle_middle(left, receiver);
    const Vec2 centre = frame.coordinates(left.centre);
    const Vec2 scale{glm::length(left.along) / glm::length(frame.along),
                     glm::length(left.across) / glm::length(frame.across)};
    const Vec2 from_centre = scale * seen.middle;
    const double product = scale.x * scale.y * seen.product + centre.x * from_centre.y + centre.y * from_centre.x;
    return KernelMiddle{seen.factor, centre + from_centre, product + centre.x * centre.y};
}

bool is_below_horizon(const Polygon& outline, const Receiver& receiver) {
    return std::all_of(outline.begin(), outline.end(), [&](const Vec3& corner) {
        return glm::dot(corner - receiver.position, receiver.normal) <= 0.0;
    });
}

}  // namespace

FactorRows::FactorRows(const Mesh& mesh, const Nodes& nodes) : mesh_(mesh), nodes_(nodes), layouts_(layouts_of(mesh)) {
    HANEI_CHECK(nodes.patches() == mesh.patches.size());
    for (std::size_t p = 0; p < mesh.patches.size(); ++p) {
        const Patch& patch = mesh.patches[p];
        const Face& face = mesh.faces[patch.face].face;
        const bool known = nodes.elements == Elements::linear;
        frames_.push_back(known ? nodes.frame(p) : frame_of(patch.outline, face.normal, face.along));
        rectangles_.push_back(is_rectangle(patch.outline));
    }
    for (const FaceLayout& layout : layouts_) {
        flat_.emplace_back(mesh, *layout.face, nodes.elements, frames_);
        most_patches_ = std::max<std::size_t>(most_patches_, layout.face->patch_count);
    }
}

void FactorRows::write(std::span<const Receiver> side_by_side, float* rows) const {
    std::vector<std::uint32_t> others(most_patches_ + 1);
    for (std::size_t face = 0; face < layouts_.size(); ++face) {
        for (std::size_t k = 0; k < side_by_side.size(); ++k) {
            write_face(face, side_by_side[k], others, rows + k * columns());
        }
    }
}

void FactorRows::write_face(std::size_t face, const Receiver& receiver, std::span<std::uint32_t> others,
                            float* row) const {
    const FaceLayout& layout = layouts_[face];
    const FaceSeen seen = seen_from(layout, receiver);
    if (seen == FaceSeen::hidden) return;
    if (seen == FaceSeen::touching) return write_touching(layout, receiver, row);
    const FarPatches& flat = flat_[face];
    const FlatReceiver at = flat.flat(receiver);
    const bool horizon_cuts = seen == FaceSeen::partly;
    float* columns = row + layout.face->first_patch * nodes_.per_patch;
    flat.write_far(at, columns);
    const std::size_t count = flat.list_others(at, horizon_cuts, others.data());
    for (const std::uint32_t patch : others.first(count)) {
        if (flat.write_by_points(patch, at, horizon_cuts, columns)) continue;
        write_nearby(layout.face->first_patch + patch, receiver, horizon_cuts, row);
    }
}

void FactorRows::write_nearby(std::size_t patch, const Receiver& receiver, bool horizon_cuts, float* row) const {
    const Polygon& outline = mesh_.patches[patch].outline;
    const PatchFrame& frame = frames_[patch];
    float* columns = row + patch * nodes_.per_patch;
    const bool linear = nodes_.elements == Elements::linear;
    if (horizon_cuts && is_below_horizon(outline, receiver)) {
        std::fill_n(columns, nodes_.per_patch, 0.0F);
    } else if (!rectangles_[patch]) {
        put(nodes_, outline, frame, receiver, columns);
    } else if (!horizon_cuts || is_above_horizon(outline, receiver)) {
        if (linear) return put_shares(rectangle_middle(frame, receiver), columns);
        *columns = static_cast<float>(rectangle_factor(frame, receiver));
    } else {
        const auto seen = linear ? cut_rectangle(outline, frame, receiver) : std::nullopt;
        seen ? put_shares(*seen, columns) : put(nodes_, outline, frame, receiver, columns);
    }
}

void FactorRows::write_touching(const FaceLayout& layout, const Receiver& receiver, float* row) const {
    const MeshFace& face = *layout.face;
    const double height = glm::dot(receiver.position - layout.corners.front(), face.face.normal);
    for (std::size_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p) {
        // of a face whose plane holds the receiver only patches that reach it are seen, as a limit
        const Patch& patch = mesh_.patches[p];
        if (height <= layout.same_place && !reaches(patch, receiver.position, layout.same_place)) continue;
        put(nodes_, patch.outline, frames_[p], receiver, row + p * nodes_.per_patch);
    }
}

}  // namespace hanei
