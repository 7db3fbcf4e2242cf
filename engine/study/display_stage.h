/// The display mesh: its cells with direct light and, laid over it, the light from surfaces.
#pragma once

#include "engine/study/display_cells.h"
#include "engine/study/vertex_light.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace hanei {

/// A luminaire's light as the scene sets it.
struct WeightedEmitter {
    Emitter emitter;
    double share = 1.0;
};
std::vector<WeightedEmitter> emitters_of(const Scene& scene);

/// Direct light at receivers from all emitters; empty when stopped.
std::optional<std::vector<double>> direct_from_all(std::span<const WeightedEmitter> emitters,
                                                   std::span<const Receiver> receivers, const OccluderSet* occluders,
                                                   const Work& work);

struct DisplayInput {
    const Scene* scene = nullptr;
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const OccluderSet> occluders;  ///< null: no shadows
    Accuracy accuracy;                             ///< of each luminaire's direct light
    bool open = false;                             ///< also without shadows
    int finest = 4;                                ///< a cell is halved at most this often
    bool live = false;  ///< the scene is being dragged: on the cells of before while the mesh is the same
};

/// Light from surfaces, lx, one value a mesh vertex.
struct LightOfSurfaces {
    std::vector<double> interreflected;
    std::vector<std::vector<double>> bands;  ///< the same in each colour band; none: the same in all
    std::vector<double> open;                ///< of the room without shadows; empty when not wanted
};

/// Keeps direct light per luminaire at every vertex: dimming weighs it anew, a moved luminaire lights
/// its own. Cells are those of the scene's light, whatever was shown before; while the scene is being
/// dragged those of before stay.
class DisplayStage {
public:
    /// Brings cells and direct light up to date.
    /// Returns   false when stopped.
    bool update(const DisplayInput& input, const Work& work);
    double flux() const { return light_.flux(); }  ///< lm, of all luminaires as the scene sets them
    bool reused() const { return reused_; }        ///< the last update() neither cut nor lit anything

    /// Needs     a successful update().
    std::shared_ptr<const DisplayMesh> dressed(const LightOfSurfaces& light) const;

private:
    bool cut(const DisplayInput& input, const Work& work);

    DisplayPlaces places_;
    VertexLight light_, open_light_;
    std::shared_ptr<const Mesh> mesh_;  ///< of the cut
    DisplayCut cut_;
    bool is_of_the_light_ = false;  ///< the cut is that of the light as it is
    bool open_ = false, coloured_ = false, reused_ = false;
};

}  // namespace hanei
