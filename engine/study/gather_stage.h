/// Light from surfaces at a set of other places, kept side by side of light.
#pragma once

#include "engine/study/light_mix.h"
#include "engine/study/rows_stage.h"

#include <map>
#include <memory>
#include <vector>

namespace hanei {

/// lx at every receiver, as the dimmers say.
struct GatheredLight {
    std::vector<double> interreflected;
    std::vector<double> iteration;           ///< gathered from the half widths of exitance
    std::vector<std::vector<double>> bands;  ///< interreflected in each colour band; none when there is one
};

class GatherStage {
public:
    /// What is gathered from: exitance and its half width at the nodes of patches.
    struct Source {
        std::vector<double> exitance, half_width;
    };
    using SourceOf = std::function<Source(const SideLight&)>;

    /// Returns   empty when stopped.
    std::optional<GatheredLight> get(const RowsInput& rows, std::span<const MixPart> parts, const SourceOf& source_of,
                                     const Work& work);
    bool reused() const { return reused_; }  ///< the last get() gathered nothing

private:
    struct Kept {
        std::shared_ptr<const SideLight> light;  ///< held, so that no other takes its place in memory
        std::vector<double> interreflected, iteration;
    };
    bool gather(const std::vector<std::shared_ptr<const SideLight>>& lights, const SourceOf& source_of,
                const StoredRows& rows, const Work& work);

    RowsStage rows_;
    std::shared_ptr<const void> version_;  ///< of the rows that `kept_` was gathered by
    std::map<const SideLight*, Kept> kept_;
    bool reused_ = false;
};

}  // namespace hanei
