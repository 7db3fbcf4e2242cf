/// Why the light of a scene is worked out in one band of colour or in three.
#pragma once

#include "engine/scene/scene.h"

#include <string>

namespace hanei {

struct ColourReason {
    bool coloured = false;  ///< three bands: the scene is not neutral (colour.h)
    std::string why;        ///< names the materials and the lamps' temperatures that ask for it
};

ColourReason colour_reason(const Scene& scene);

}  // namespace hanei
