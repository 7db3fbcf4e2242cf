/// The light of several emitters of one luminaire as one photometry.
#pragma once

#include "engine/scene/photometry.h"

#include <optional>
#include <span>

namespace hanei {

/// Intensities added in every direction. The table has every angle of every part, so that the sum of the
/// parts' bilinear interpolants is its own: no error but rounding. Where a part ends before the pole with
/// light left, an angle a thousandth of a degree further on carries the sum without it.
///
/// Needs     parts whose tables hang together (intensity.h), unturned.
/// Returns   the first part with the table, lamps, lamp lumens, watts and symmetry of all; empty when the
///           parts are of different photometric types, or the table would exceed 4 million intensities.
/// Weak when a part of type A or B ends sideways with light left: the sum slopes down to the next plane.
std::optional<Photometry> photometric_sum(std::span<const Photometry> parts);

}  // namespace hanei
