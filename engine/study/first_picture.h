/// A picture of a room that was never shown, long before its answer: solved in wide patches.
#pragma once

#include "engine/study/carried_light.h"
#include "engine/study/level.h"

namespace hanei {

class FirstPicture {
public:
    struct Made {
        std::shared_ptr<const Mesh> mesh;
        std::shared_ptr<const DisplayMesh> display;
        LightOfSurfaces light;  ///< at the mesh's vertices
        double flux = 0.0;      ///< lm, of all luminaires as the scene sets them
    };
    /// Needs     the input of the full answer.
    /// Returns   empty when stopped.
    /// Cost      about a fortieth of a full answer's form factors.
    std::optional<Made> make(const LevelInput& input, const Work& work, StageClock& clock);

private:
    Level level_;
    DisplayStage display_;
};

/// From an answer of the level at its unknowns.
LightOfSurfaces light_at_vertices(const Level& level, const LevelAnswer& answer);

}  // namespace hanei
