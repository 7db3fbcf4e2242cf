#include "engine/study/pixel_light.h"

#include "engine/base/check.h"
#include "engine/study/display_stage.h"

#include <algorithm>

namespace hanei {

struct PixelLight::Parts {
    SolutionSnapshot solution;
    std::vector<WeightedEmitter> emitters;
    const OccluderSet* occluders = nullptr;  ///< the solution's; null: no shadows
};

PixelLight::PixelLight(SolutionSnapshot solution, bool shadows) {
    Parts parts{solution, emitters_of(*solution->scene), nullptr};
    if (shadows && solution->plan.simulates(Effect::occlusion_direct)) parts.occluders = solution->occluders.get();
    parts_ = std::make_shared<const Parts>(std::move(parts));
}

void PixelLight::direct(std::span<const Receiver> receivers, std::span<double> lux) const {
    HANEI_CHECK(lux.size() == receivers.size());
    const auto arriving = direct_from_all(parts_->emitters, receivers, parts_->occluders, Work{});
    std::copy(arriving->begin(), arriving->end(), lux.begin());
}

}  // namespace hanei
