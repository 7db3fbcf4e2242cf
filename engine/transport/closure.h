/// The paper's factors brought to the sums they should have.
#pragma once

#include <span>

namespace hanei {

/// Sum of factors times shares, one share a factor or one for several side by side.
double visible_sum(std::span<const float> factors, std::span<const float> shares);

/// Scales a row of factors so that its sum of factor x share is the one given: point to point factors
/// are far too large next to an edge and beneath furniture; then no more light arrives than leaves.
///
/// Returns   the row as it was where nothing of it is visible.
/// Weak when few grid points of a row are visible: they then stand for all that is.
void close_row(std::span<float> factors, std::span<const float> shares, double sum);

}  // namespace hanei
