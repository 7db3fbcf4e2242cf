#include "engine/transport/factor_rows.h"

#include "engine/base/check.h"

#include <algorithm>

namespace hanei {

FactorRows::FactorRows(const Mesh& mesh, const Nodes& nodes) : mesh_(mesh), nodes_(nodes), layouts_(layouts_of(mesh)) {
    HANEI_CHECK(nodes.patches() == mesh.patches.size());
}

void FactorRows::write(std::span<const Receiver> side_by_side, float* rows) {
    for (std::size_t k = 0; k < side_by_side.size(); ++k) {
        for (const FaceLayout& layout : layouts_) {
            const FaceSeen seen = seen_from(layout, side_by_side[k]);
            if (seen != FaceSeen::hidden) write_face(layout, side_by_side[k], seen, rows + k * columns());
        }
    }
}

void FactorRows::write_face(const FaceLayout& layout, const Receiver& receiver, FaceSeen seen, float* row) const {
    const MeshFace& face = *layout.face;
    const double height = glm::dot(receiver.position - layout.corners.front(), face.face.normal);
    const bool in_plane = seen == FaceSeen::touching && height <= layout.same_place;
    for (std::size_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p) {
        const Polygon& outline = mesh_.patches[p].outline;
        // of a face whose plane holds the receiver only patches that reach it are seen, as a limit
        if (in_plane && !reaches(mesh_.patches[p], receiver.position, layout.same_place)) continue;
        if (nodes_.elements == Elements::constant) {
            row[p] = static_cast<float>(configuration_factor(outline, receiver));
            continue;
        }
        const std::array<double, 4> shares = node_shares(kernel_middle(outline, nodes_.frame(p), receiver));
        for (std::size_t k = 0; k < 4; ++k) row[4 * p + k] = static_cast<float>(shares[k]);
    }
}

}  // namespace hanei
