/// Direct light at as many places of a solved room as a picture has pixels (the paper's step 8).
#pragma once

#include "engine/solution/solution.h"

#include <memory>
#include <span>
#include <vector>

namespace hanei {

/// Holds     the solution. Immutable once made: any thread may ask.
class PixelLight {
public:
    /// Without `shadows` nothing stands in the light's way; nor where the solution's plan skips
    /// direct shadows.
    explicit PixelLight(SolutionSnapshot solution, bool shadows = true);

    /// Direct illuminance at every receiver, lx: what value_at gives there, to the last bit.
    /// Cost      0.3 us a receiver and luminaire in free light, 1 to 2 us where shadows may fall, when
    ///           receivers that follow one another lie side by side on one face: what can shade 64 of
    ///           them is found once.
    void direct(std::span<const Receiver> receivers, std::span<double> lux) const;

private:
    struct Parts;
    std::shared_ptr<const Parts> parts_;
};

}  // namespace hanei
