/// What hard_spots notes while it looks; and what is hard about two objects together.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/scene/scene.h"

#include <map>
#include <string>
#include <string_view>

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

    void note(std::string_view list, std::size_t index, std::string_view kind, std::string_view name, ObjectId id,
              std::string_view field, const std::string& message);
    /// Of many alike only the first is told, with their number: call told_of_others() at the end.
    void told_of_others();
    void note_whole(std::string_view field, const std::string& message);
};

/// Bodies that touch or leave a gap below a millimetre, sheets in one place or one plane.
void look_at_pairs(HardSpots& spots);

}  // namespace hanei
