/// Rooms that keep all their light: no balance exists.
#pragma once

#include "engine/transport/balance.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace hanei {

/// The unknowns whose light is never lost, and which some light reaches: reflectance 1 all around, no
/// opening. Their illuminance would grow with every reflection for ever, so the study must be refused.
///
/// An unknown loses light when it absorbs or sees nothing in some direction: 1 - reflectance x row sum
/// above a millionth; or when it sees unknowns that do, which is repeated until no more are found. Those
/// left see each other alone and reflect everything: (1 - A) with A = reflectance x rows is singular on
/// them, whereas every unknown found has a way to where light is lost, and its light dies out.
///
/// Needs     `emitted`: own exitance + reflected direct light, one an unknown; `row_error`: how far row
///           sums of a closed room may be from 1 (FactorRows: 3e-6; compact StoredRows: 2e-3).
/// Returns   in ascending order; no unknown where a balance exists; empty optional when stopped.
/// Weak when an opening takes less of every row than `row_error`: it is taken for closed.
/// Cost      nothing below reflectance 1; else a product for the row sums and one for every surface on
///           the longest way to a dark one, and from a lit one: two or three.
std::optional<std::vector<std::size_t>> closed_unknowns(const Exchange& exchange, std::span<const double> reflectance,
                                                        std::span<const double> emitted, const Work& work,
                                                        double row_error = 1e-5);

}  // namespace hanei
