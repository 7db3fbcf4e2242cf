/// Illuminance straight from luminaires, with umbra and penumbra, exact: nothing is sampled but the
/// directional distribution of measured openings, and for these every value comes with by how much it
/// may be off (measured_source.h, opening_integral.h).
#pragma once

#include "engine/base/progress.h"
#include "engine/base/quantity.h"
#include "engine/direct/accuracy.h"
#include "engine/direct/estimate.h"
#include "engine/geometry/configuration_factor.h"
#include "engine/geometry/occluders.h"
#include "engine/scene/scene.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace hanei {

/// A convex part of a luminous opening. Light goes only to places p with (p - c) . front > 0 for
/// some of its corners c; a zero front shines all around.
struct LuminousPiece {
    Polygon corners;  ///< two for a line, one for a point
    Vec3 front{0.0};  ///< unit, or zero
};

/// A luminaire made ready to shine at full output: openings in scene coordinates, cut into convex
/// pieces, with their luminance. Dimming and maintenance factor are not in it.
class Emitter {
public:
    /// Needs     a scene without errors (check_scene); `luminaire` one of its luminaires.
    Emitter(const Scene& scene, const Luminaire& luminaire);

    /// Illuminance at the receiver. Sources without extent have hard shadows; a point on the shadow's
    /// very edge is lit. Occluders are those of the whole scene; null means unobstructed.
    /// Returns   never negative, never NaN.
    Illuminance illuminance(const Receiver& receiver, const OccluderSet* occluders) const;

    /// The same where only the bodies `among` can be in the way (ascending): for many receivers side
    /// by side, found once.
    Illuminance illuminance(const Receiver& receiver, const OccluderSet& occluders,
                            std::span<const BodyIndex> among) const;

    /// The same with by how much the value may be off, lx: 0 but for measured openings, whose light is
    /// worked out no further than `accuracy` asks for.
    Estimate estimate(const Receiver& receiver, const OccluderSet* occluders, const Accuracy& accuracy = {}) const;
    Estimate estimate(const Receiver& receiver, const OccluderSet& occluders, std::span<const BodyIndex> among,
                      const Accuracy& accuracy = {}) const;

    LuminousFlux flux() const;  ///< at full output
    ObjectId luminaire() const;

    /// Points whose convex hull holds the whole opening.
    std::span<const Vec3> extent() const;

    /// The opening in convex parts; none when it gives no light.
    std::span<const LuminousPiece> pieces() const;

private:
    struct Parts;
    std::shared_ptr<const Parts> parts_;
};

/// Illuminance at every receiver from one emitter at full output; empty when stopped.
std::optional<std::vector<double>> direct_illuminance(const Emitter& emitter, std::span<const Receiver> receivers,
                                                      const OccluderSet* occluders, const Work& work);

/// The same, followed by as many errors of these values.
std::optional<std::vector<double>> direct_estimates(const Emitter& emitter, std::span<const Receiver> receivers,
                                                    const OccluderSet* occluders, const Accuracy& accuracy,
                                                    const Work& work);
std::optional<std::vector<double>> direct_estimates(const Emitter& emitter, std::span<const Receiver> receivers,
                                                    const OccluderSet* occluders, const Work& work);

/// Mean illuminance over every convex polygon (patch). In free light 2 x 2 Gauss points (3 in a
/// triangle), four times as many once or twice more where they differ by over 5 %; 4 x 4 and up to
/// 8 x 8 where a body stands between the patch and the opening, none where the patch is proved unlit
/// (light_class.h).
///
/// Holds     1e-4 in free light; on the floor under desks with 5 cm legs, at 0.25 m patches, 0.5 % of
///           the mean illuminance (RMS) in penumbra, 3.5 % in the hard shadows of point sources.
struct ReceivingPolygon {
    std::span<const Vec3> outline;
    Vec3 normal;
};
std::optional<std::vector<double>> mean_direct_illuminance(const Emitter& emitter,
                                                           std::span<const ReceivingPolygon> polygons,
                                                           const OccluderSet* occluders, const Work& work);

/// The same, followed by as many errors of these means: what the spread of the points leaves open, and
/// what the points themselves may be off by. No more points are asked than `accuracy` needs.
std::optional<std::vector<double>> mean_direct_estimates(const Emitter& emitter,
                                                         std::span<const ReceivingPolygon> polygons,
                                                         const OccluderSet* occluders, const Accuracy& accuracy,
                                                         const Work& work);

}  // namespace hanei
