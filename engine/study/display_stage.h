/// The display mesh: patches with a value at every corner, cut finer where direct light bends, so
/// that a desk's shadow does not look like stairs.
#pragma once

#include "engine/direct/direct.h"
#include "engine/solution/solution.h"

#include <array>
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

/// A vertex of the display by the mesh vertices it lies among: bilinear in u and v.
struct DisplaySource {
    std::array<VertexId, 4> among{};
    double u = 0.0, v = 0.0;
};

/// The display's cells with direct light, before light from surfaces is laid over it.
struct DirectDisplay {
    DisplayMesh display;                 ///< direct and position filled
    std::vector<DisplaySource> sources;  ///< one a vertex
    std::vector<float> open_direct;      ///< lx without shadows; empty unless asked for
};

struct DisplayInput {
    const Mesh* mesh = nullptr;
    std::span<const WeightedEmitter> emitters;
    const OccluderSet* occluders = nullptr;  ///< null: no shadows
    bool open = false;                       ///< also without shadows
    int finest = 4;                          ///< a cell is halved at most this often
    std::size_t budget = 60'000;             ///< no cell is cut once there are more vertices
};

/// Cuts a cell in four while its corners differ by more than the eye would see of it: 8 % of the
/// darkest corner and 0.5 % of the brightest vertex, and while a finer neighbour's vertex on its edge
/// differs as much from what is drawn there: a shadow found in one cell is followed into the next.
/// Every cell is cut at least once.
/// Returns   empty when stopped.
std::optional<DirectDisplay> make_direct_display(const DisplayInput& input, const Work& work);

/// The display with interreflected light, lx, one value a mesh vertex. `open_interreflected` is
/// that of the room without shadows; empty when not wanted.
std::shared_ptr<const DisplayMesh> dressed(const DirectDisplay& direct, std::span<const double> interreflected,
                                           std::span<const double> open_interreflected);

}  // namespace hanei
