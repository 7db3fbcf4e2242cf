/// The light at places that are seen: direct light exact, interreflected light interpolated.
#pragma once

#include "engine/base/progress.h"
#include "ui/view/exact_picture.h"
#include "ui/view/sight.h"

#include <span>
#include <vector>

namespace hanei {

/// Holds     borrowed: the solution and the function.
class SurfaceLight {
public:
    SurfaceLight(const Solution& solution, const DirectLight& direct, LightPart part);

    /// Once before anything is asked. Returns false when stopped.
    bool prepare(const Work& work);

    /// lx at places of one face. Any thread may ask.
    std::vector<double> at(std::span<const Seen> places, const Sight& sight) const;

private:
    bool take_direct_from_vertices(const Work& work);

    const Solution& solution_;
    const DirectLight& direct_;
    LightPart part_;
    std::vector<double> laid_over_;  ///< lx, one a display vertex: what is interpolated
};

}  // namespace hanei
