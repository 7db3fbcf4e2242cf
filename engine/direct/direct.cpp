#include "engine/direct/direct.h"

#include "engine/base/tiles.h"

namespace hanei {

namespace {

/// Bodies that any of the receivers may find between it and the emitter.
std::vector<BodyIndex> bodies_before(std::span<const Receiver> receivers, const Emitter& emitter,
                                     const OccluderSet* occluders) {
    std::vector<BodyIndex> found;
    if (!occluders || receivers.empty()) return found;
    Box around{receivers[0].position, receivers[0].position};
    for (const Receiver& receiver : receivers) around.include(receiver.position);
    occluders->between(around, emitter.extent(), found);
    return found;
}

}  // namespace

std::optional<std::vector<double>> direct_estimates(const Emitter& emitter, std::span<const Receiver> receivers,
                                                    const OccluderSet* occluders, const Accuracy& accuracy,
                                                    const Work& work) {
    std::vector<double> arriving(2 * receivers.size());
    const bool finished = for_each_tile(receivers.size(), 64, work, [&](std::size_t begin, std::size_t end) {
        const std::vector<BodyIndex> among = bodies_before(receivers.subspan(begin, end - begin), emitter, occluders);
        for (std::size_t k = begin; k < end; ++k) {
            const Estimate here = among.empty() ? emitter.estimate(receivers[k], nullptr, accuracy)
                                                : emitter.estimate(receivers[k], *occluders, among, accuracy);
            arriving[k] = here.value;
            arriving[receivers.size() + k] = here.error;
        }
    });
    if (!finished) return std::nullopt;
    return arriving;
}

std::optional<std::vector<double>> direct_estimates(const Emitter& emitter, std::span<const Receiver> receivers,
                                                    const OccluderSet* occluders, const Work& work) {
    return direct_estimates(emitter, receivers, occluders, Accuracy{}, work);
}

std::optional<std::vector<double>> direct_illuminance(const Emitter& emitter, std::span<const Receiver> receivers,
                                                      const OccluderSet* occluders, const Work& work) {
    auto arriving = direct_estimates(emitter, receivers, occluders, work);
    if (arriving) arriving->resize(receivers.size());
    return arriving;
}

}  // namespace hanei
