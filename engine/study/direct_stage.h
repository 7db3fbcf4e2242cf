/// Direct light at one set of receivers, kept per luminaire at full output: moving one luminaire
/// computes that one, a body that moved only where its shadow can fall, dimming only re-weighs.
#pragma once

#include "engine/direct/direct.h"
#include "engine/study/body_changes.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace hanei {

/// Light of a luminaire as the scene sets it: its dimming and its group's times the maintenance factor.
double output_share(const Scene& scene, const Luminaire& luminaire);

/// Where light arrives, and how it is computed.
struct LightReceivers {
    std::shared_ptr<const void> identity;  ///< an object that is the same as long as the receivers are
    std::size_t count = 0;
    std::size_t figures = 1;                                   ///< of each receiver, side by side in the list of values
    std::function<std::span<const Vec3>(std::size_t)> places;  ///< a receiver's extent: a point, corners of a patch
    /// Figures of the receivers named, in that order; empty when stopped.
    std::function<std::optional<std::vector<double>>(const Emitter&, std::span<const std::uint32_t> which)> compute;
    Accuracy accuracy;           ///< what `compute` aims at
    bool finer_will_do = false;  ///< values kept from a more exact computation need not be made anew
};

class DirectStage {
public:
    using Values = std::shared_ptr<const std::vector<double>>;

    /// Figures of all receivers, lx, from one luminaire at full output. The same object as long as
    /// nothing that can change them did.
    /// Returns   null when stopped.
    Values of(const Scene& scene, const Luminaire& luminaire, const LightReceivers& receivers,
              const std::shared_ptr<const OccluderSet>& occluders);

    /// Sum over all luminaires that shine, as the scene sets them.
    std::optional<std::vector<double>> sum(const Scene& scene, const LightReceivers& receivers,
                                           const std::shared_ptr<const OccluderSet>& occluders);

    void forget_others(const Scene& scene);  ///< luminaires that the scene has no more

    bool reused() const { return reused_; }  ///< no luminaire was computed since start(), nor part of one
    void start() { reused_ = true; }

private:
    struct Entry {
        Luminaire light;
        std::optional<Photometry> photometry;
        std::shared_ptr<const void> receivers;
        Accuracy accuracy;
        std::shared_ptr<const OccluderSet> occluders;
        Values values;
    };
    static std::vector<std::uint32_t> touched(const Emitter& emitter, const LightReceivers& receivers,
                                              const BodyChanges& changes);

    std::map<ObjectId, Entry> entries_;
    LastBodyChanges changes_;
    bool reused_ = true;
};

}  // namespace hanei
