#include "engine/transport/factor_rows.h"

#include "engine/base/check.h"
#include "engine/transport/rectangle_kernel.h"

#include <algorithm>

namespace hanei {

namespace {

void put(const Nodes& nodes, const Polygon& outline, const PatchFrame& frame, const Receiver& receiver,
         float* columns) {
    if (nodes.elements == Elements::constant) {
        *columns = static_cast<float>(configuration_factor(outline, receiver));
        return;
    }
    const std::array<double, 4> shares = node_shares(kernel_middle(outline, frame, receiver));
    std::transform(shares.begin(), shares.end(), columns, [](double share) { return static_cast<float>(share); });
}

bool is_below_horizon(const Polygon& outline, const Receiver& receiver, double thickness) {
    return std::all_of(outline.begin(), outline.end(), [&](const Vec3& corner) {
        return glm::dot(corner - receiver.position, receiver.normal) <= thickness;
    });
}
bool is_above_horizon(const Polygon& outline, const Receiver& receiver) {
    return std::all_of(outline.begin(), outline.end(), [&](const Vec3& corner) {
        return glm::dot(corner - receiver.position, receiver.normal) >= 0.0;
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
    const FlatFace& flat = flat_[face];
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
    float* columns = row + patch * nodes_.per_patch;
    if (horizon_cuts && is_below_horizon(outline, receiver, 0.0)) {
        std::fill_n(columns, nodes_.per_patch, 0.0F);
    } else if (!rectangles_[patch] || (horizon_cuts && !is_above_horizon(outline, receiver))) {
        put(nodes_, outline, frames_[patch], receiver, columns);
    } else if (nodes_.elements == Elements::constant) {
        *columns = static_cast<float>(rectangle_factor(frames_[patch], receiver));
    } else {
        const std::array<double, 4> shares = node_shares(rectangle_middle(frames_[patch], receiver));
        std::transform(shares.begin(), shares.end(), columns, [](double share) { return static_cast<float>(share); });
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
