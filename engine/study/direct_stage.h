/// Direct light at one set of receivers, kept per luminaire at full output: moving one luminaire
/// computes that one, dimming only re-weighs.
#pragma once

#include "engine/direct/direct.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace hanei {

/// Light of a luminaire as the scene sets it: dimming times maintenance factor.
double output_share(const Scene& scene, const Luminaire& luminaire);

class DirectStage {
public:
    using Compute = std::function<std::optional<std::vector<double>>(const Emitter&)>;

    /// Sum over all luminaires of `count` figures each, lx: values of receivers, their errors after them.
    ///
    /// Needs     `receivers`: an object that is the same as long as the receivers are; `occluders`
    ///           may be null (no shadows). `compute` gives the values of one emitter.
    /// Returns   empty when stopped.
    std::optional<std::vector<double>> sum(const Scene& scene, std::size_t count,
                                           const std::shared_ptr<const void>& receivers,
                                           const std::shared_ptr<const OccluderSet>& occluders, const Compute& compute);

    bool reused() const { return reused_; }  ///< the last sum computed no luminaire anew

private:
    struct Entry {
        Luminaire light;
        std::optional<Photometry> photometry;
        std::shared_ptr<const void> receivers;
        std::shared_ptr<const OccluderSet> occluders;
        std::vector<double> values;
    };
    std::map<ObjectId, Entry> entries_;
    bool reused_ = false;
};

}  // namespace hanei
