/// The paper's factors brought to the sums they should have.
#pragma once

#include "engine/transport/factors.h"

#include <optional>
#include <span>
#include <vector>

namespace hanei {

/// For each receiver the share of its hemisphere, weighted by the cosine, that is patches it sees: 1 in
/// a closed room, less by what openings take. Analytic factors and visible parts, not the paper's.
/// Returns   nothing when stopped.
std::optional<std::vector<double>> seen_sums(const Mesh& mesh, std::span<const Receiver> receivers,
                                             const OccluderSet& occluders, const Work& work);

/// Scales every row of factors so that its sum of factor x visibility is the one given: point to point
/// factors are far too large next to an edge and beneath furniture, and then no more light arrives
/// than leaves.
///
/// Returns   a row as it was where nothing of it is visible or the sum given is not a number.
/// Weak when few grid points of a row are visible: they then stand for all that is.
void close_rows(DenseRows& factors, const Visibility& visibility, std::span<const double> sums);

}  // namespace hanei
