#include "ui/panels/exact_room.h"

#include "engine/study/pixel_light.h"

namespace hanei {

std::shared_ptr<const ExactPicture> exact_room(const SolutionSnapshot& solution, const ExactRequest& request,
                                               const Work& work) {
    const PixelLight light(solution, request.options.part != LightPart::unshadowed);
    const DirectLight direct = [&](std::span<const Receiver> receivers, std::span<double> lux) {
        light.direct(receivers, lux);
    };
    std::optional<ExactPicture> made = exact_picture(*solution, direct, request, work);
    return made ? std::make_shared<const ExactPicture>(std::move(*made)) : nullptr;
}

}  // namespace hanei
