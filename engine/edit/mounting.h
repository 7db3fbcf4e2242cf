/// Ways to hold luminaires: where they come to hang and which way they face.
#pragma once

#include "engine/scene/scene.h"

#include <span>
#include <string_view>

namespace hanei {

enum class Mounting {
    recessed,  ///< flush with the ceiling
    surface,   ///< below the ceiling by the height of a housing
    pendant,   ///< by a suspension
    wall,      ///< on the nearest wall
    standing,  ///< on the floor
};
inline constexpr Mounting mountings[] = {Mounting::recessed, Mounting::surface, Mounting::pendant, Mounting::wall,
                                         Mounting::standing};
std::string_view name_of(Mounting mounting);  ///< "Recessed in the ceiling"

struct MountingWish {
    Mounting mounting = Mounting::recessed;
    double suspension = 0.5;  ///< m, from the ceiling to the top of a pendant's opening
    double height = 1.8;      ///< m above the floor, of a luminaire's place on a wall or a stand
};

/// These luminaires held so; ids of other things are passed over. At a ceiling and on a stand they
/// hang upright and keep their turn about the vertical. On a wall their back is to it: one that
/// shines down and alike to all sides looks into the room with its opening, any other stays upright
/// and turns the side it favours to the room. Nothing leaves the room by it.
///
/// Needs     a room; without one the scene stays as it is.
Scene mounted(Scene scene, std::span<const ObjectId> luminaires, const MountingWish& wish);

/// How the luminaire looks held, from its place and its room.
MountingWish mounting_of(const Scene& scene, const Luminaire& luminaire);

}  // namespace hanei
