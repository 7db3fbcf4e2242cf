/// Bodies and plans that are right but for the direction in which their corners are listed.
#pragma once

#include "engine/scene/scene.h"

#include <string>
#include <vector>

namespace hanei {

struct RepairedWinding {
    std::string field;  ///< "furniture[2].parts[0].faces"
    ObjectId object;
    std::string message;
};

/// Turns a clockwise plan (with its walls and their sub-areas) and inside-out solids round.
std::vector<RepairedWinding> repair_windings(Scene& scene);

}  // namespace hanei
