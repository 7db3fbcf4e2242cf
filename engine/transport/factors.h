/// Form factors from receivers to patches, and how much of each patch the receiver sees. Kept
/// apart: what moves in the room changes visibility only.
#pragma once

#include "engine/mesh/mesh.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace hanei {

/// A dense matrix, one row a receiver, one column a patch.
struct DenseRows {
    std::size_t rows = 0, columns = 0;
    std::vector<float> values;
    std::span<const float> row(std::size_t k) const { return {values.data() + k * columns, columns}; }
};

/// Analytic form factors from receivers to whole patches, nothing in between.
/// Holds     row sums of 1 in a closed room to the rounding of a float.
std::optional<DenseRows> patch_factors(const Mesh& mesh, std::span<const Receiver> receivers, const Work& work);

/// The share (0 to 1) of each of those factors that is not hidden by occluders; empty rows when
/// nothing is hidden anywhere (`all_visible`).
struct Visibility {
    bool all_visible = true;
    DenseRows share;
};
std::optional<Visibility> patch_visibility(const Mesh& mesh, std::span<const Receiver> receivers,
                                           const OccluderSet& occluders, const Work& work);

/// The same after bodies came, went or moved: `before` holds but where one of them, as it was or as
/// it is, can stand between a receiver and a face; only there it is worked out anew.
/// Needs     `before` of the same mesh and receivers; `gone` and `come`: the bodies that are in one
///           of the two sets of occluders only.
/// Returns   the same bits as patch_visibility; empty when stopped.
std::optional<Visibility> updated_visibility(Visibility before, const Mesh& mesh, std::span<const Receiver> receivers,
                                             const OccluderSet& gone, const OccluderSet& come,
                                             const OccluderSet& occluders, const Work& work);

/// Form factor from polygon to polygon (both flat and convex or not), mean over the first, past
/// occluders; adaptive to a relative error of about 1e-7.
double form_factor(const Region& from, const Region& to, const OccluderSet& occluders);

}  // namespace hanei
