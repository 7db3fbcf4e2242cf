/// The rival of the exact answer: shadow rays to a low-discrepancy lattice on the panel (Embree).
#pragma once

#include "engine/base/vector.h"
#include "engine/geometry/configuration_factor.h"
#include "engine/geometry/occluders.h"

#include <embree3/rtcore.h>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

namespace hanei::bench {

/// Bodies as triangles in an Embree scene.
class ShadowRays {
public:
    explicit ShadowRays(std::span<const ConvexBody> bodies);

    /// Sets the number of samples, a multiple of 16: the R2 lattice (Roberts 2018) over a panel.
    void set_samples(int count);

    /// Share of the panel's light that arrives, by packets of 16 rays. Samples are weighted by their
    /// cosines and distance and divided by the weights' sum, so that a receiver in full light is exact
    /// and only the penumbra is sampled.
    double visible_share(const Receiver& receiver, const Vec3& panel) const;

private:
    template <class T>
    struct Release {
        void operator()(T* handle) const {
            if constexpr (std::is_same_v<T, RTCDeviceTy>) {
                rtcReleaseDevice(handle);
            } else {
                rtcReleaseScene(handle);
            }
        }
    };
    std::unique_ptr<RTCDeviceTy, Release<RTCDeviceTy>> device_;
    std::unique_ptr<RTCSceneTy, Release<RTCSceneTy>> scene_;
    std::vector<float> x_, y_;  ///< from the panel's middle, metres
};

}  // namespace hanei::bench
