/// Illuminance straight from luminaires, with umbra and penumbra, exact: nothing is sampled but the
/// directional distribution of measured openings, and for these every value comes with by how much it
/// may be off (measured_source.h, opening_integral.h).
#pragma once

#include "engine/base/progress.h"
#include "engine/base/quantity.h"
#include "engine/direct/accuracy.h"
#include "engine/direct/estimate.h"
#include "engine/direct/flat_cell.h"
#include "engine/direct/narrow_beam.h"
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

/// Mean illuminance over part of a patch, and how much it differs there from place to place.
struct PlaceLight {
    double mean = 0.0;
    double spread = 0.0;
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

    /// Mean illuminance over the nodes of a part of a patch if all of a piece shone from one of its
    /// places, nothing in between: the light of the piece is the mean of this over its places.
    ///
    /// Needs     shines_from_places(): false for solids that look different from every side.
    /// Returns   of a uniform face the exact mean over the part: its nodes are not asked for.
    PlaceLight from_place(std::size_t piece, const Vec3& place, const FlatCell& part, const Vec3& normal) const;
    bool shines_from_places() const;
    /// Of a point with a narrow beam.
    std::optional<NarrowBeam> narrow_beam() const;
    bool is_exact() const;    ///< at points: estimates have no error
    bool is_uniform() const;  ///< every piece is a uniform face

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

/// Mean illuminance over every convex polygon (patch). Light that nothing hides is taken at the patch's
/// nodes (flat_cell.h). Where bodies stand between, the part of the patch that each node of the opening
/// sees is cut out exactly (mean_cell.h), so that shadows of point sources are exact and penumbrae made
/// of as many shadows as the opening has nodes. Cells that leave most open are halved until what is asked
/// for is reached; patches proved unlit are not looked at.
///
/// Holds     2e-4 in free light; in a room of 48 luminaires and 258 bodies at patches of half a metre the
///           light that arrives is what they send to 1e-4, at loose accuracies too.
struct ReceivingPolygon {
    std::span<const Vec3> outline;
    Vec3 normal;
};
std::optional<std::vector<double>> mean_direct_illuminance(const Emitter& emitter,
                                                           std::span<const ReceivingPolygon> polygons,
                                                           const OccluderSet* occluders, const Work& work);

/// The same, followed by as many errors of these means. Cells are halved no further than `accuracy` needs.
///
/// Holds     97 to 99 of 100 true errors are within the claim, which is 20 to 30 times theirs in the median:
///           tables and shadows differ in how kind they are to nodes.
std::optional<std::vector<double>> mean_direct_estimates(const Emitter& emitter,
                                                         std::span<const ReceivingPolygon> polygons,
                                                         const OccluderSet* occluders, const Accuracy& accuracy,
                                                         const Work& work);

}  // namespace hanei
