/// How many luminaires a room needs for an illuminance, before anything is solved.
///
/// The lumen method n = E A / (F UF MF) with the utilization factor worked out for the room and the
/// luminaire at hand instead of read from a table (CIE 40 and CIE 52 tabulate it by room index): light
/// straight to the working plane by the intensities from the very places of a field, and what is
/// reflected by a balance between the floor, the ceiling and bands of the walls, each of one exitance
///
///     M_i = rho_i (E_i,direct + sum_j F_ij M_j)
///
/// with the exact form factors of a box. A plan that is no rectangle counts as the rectangle of its
/// area and circumference. Furniture does not count.
#pragma once

#include "engine/edit/mounting.h"

#include <optional>
#include <string>

namespace hanei {

struct LumenWish {
    double target = 500.0;         ///< lx, mean over the working plane, maintained
    double working_plane = 0.75;   ///< m above the floor
    double border = 0.5;           ///< m along the walls that the working plane leaves out (EN 12464-1)
    MountingWish mounting{};       ///< recessed, surface or pendant
    std::optional<int> columns{};  ///< along x; chosen when not given, and so are rows
    std::optional<int> rows{};
};

struct LumenAnswer {
    int columns = 0, rows = 0;
    double mean = 0.0;               ///< lx predicted on the working plane with all of them at full output
    double direct = 0.0;             ///< lx of it straight from luminaires
    double utilization = 0.0;        ///< share of the luminaires' flux that the whole working plane gets
    double room_index = 0.0;         ///< L W / (h (L + W)), h from the working plane to the luminaires
    double height = 0.0;             ///< m, from the working plane to the luminaires
    double spacing_to_height = 0.0;  ///< of the wider spacing
    double spacing_limit = 0.0;      ///< to height: beyond, it is darker between luminaires than below them
    double watts = 0.0;              ///< of all; 0 where the file states none
    double watts_per_m2 = 0.0;
    std::string refusal{};  ///< one sentence why there is no answer; then there are no figures
    int count() const { return columns * rows; }
};

/// A field of luminaires like this one for the wish: rows and columns of nearly square spacing, half a
/// spacing at the walls, no fewer than needed.
///
/// Needs     a room and a luminaire of the scene, lit downward.
/// Weak when openings are wide against their height above the working plane, and where furniture is high.
/// Cost      milliseconds.
LumenAnswer lumen_method(const Scene& scene, const Luminaire& luminaire, const LumenWish& wish);

/// The utilization factor for luminaires spread evenly over the room, as tables give it.
double utilization_factor(const Scene& scene, const Luminaire& luminaire, const LumenWish& wish);

/// Spacing to height at which two luminaires give as much midway between them as one gives below
/// itself (IES Lighting Handbook, spacing criterion): the smaller one of the planes C0 and C90, 3 at most.
double spacing_criterion(const Scene& scene, const Luminaire& luminaire);

}  // namespace hanei
