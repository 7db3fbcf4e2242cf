#include "engine/direct/direct.h"

#include "engine/base/tiles.h"

namespace hanei {

std::optional<std::vector<double>> direct_illuminance(const Emitter& emitter, std::span<const Receiver> receivers,
                                                      const OccluderSet* occluders, const Work& work) {
    std::vector<double> arriving(receivers.size());
    const bool finished = for_each_tile(receivers.size(), 64, work, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            arriving[k] = emitter.illuminance(receivers[k], occluders).value;
        }
    });
    if (!finished) return std::nullopt;
    return arriving;
}

}  // namespace hanei
