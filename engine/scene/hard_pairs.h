/// What hard_spots notes while it looks; and what is hard about objects together.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/geometry/polygon.h"
#include "engine/scene/scene.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace hanei {

struct HardSpots {
    const Scene& scene;
    double size = 0.0;       ///< m, diameter of the scene
    double thickness = 0.0;  ///< m, below which two planes are one
    Diagnostics findings = {};
    struct Told {
        std::size_t finding = 0;
        int more = 0;
    };
    std::map<std::string, Told> told = {};  ///< what was said already, and of how many others it is true

    /// About one object; `list` empty: there is but one of its kind.
    void note(std::string_view list, std::size_t index, std::string_view kind, std::string_view name, ObjectId id,
              std::string_view field, const std::string& message);
    /// Of many alike only the first is told, with their number: call told_of_others() at the end.
    void told_of_others();
    void note_whole(std::string_view field, const std::string& message);
};

/// Bodies that touch or leave a gap below a millimetre, sheets in one place or one plane or at a sharp angle.
void look_at_pairs(HardSpots& spots);

/// Calculation points in the plane of a source, close to it, in line with it, or with its middle behind them;
/// on a sheet, in a corner of the room (whose planes are given), in a lamp, by the edge of a hard shadow.
void look_at_points(HardSpots& spots, const std::vector<Plane>& room);

/// Luminaires that hide others, touch them, have a hole or hardly any extent, shine in a narrow beam, see a
/// face end on, or have a body right before them; scenes in which nothing shines.
void look_at_lights(HardSpots& spots);

}  // namespace hanei
