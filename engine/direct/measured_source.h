/// A luminous opening every element of which radiates a measured distribution.
#pragma once

#include "engine/direct/accuracy.h"
#include "engine/direct/intensity_table.h"
#include "engine/direct/obstacles.h"
#include "engine/direct/opening_integral.h"
#include "engine/geometry/configuration_factor.h"
#include "engine/scene/opening_shape.h"
#include "engine/scene/placement.h"
#include "engine/scene/point_certificate.h"
#include "engine/scene/scene.h"

#include <optional>
#include <vector>

namespace hanei {

/// The opening's surface has the luminance  k I / A  towards a direction: I the file's intensity, A the
/// luminous area projected in that direction. Far away exactly k I results, and all elements together
/// send k times the file's flux.
///
///     E = k integral of  I(e) cos / A(e)  over the solid angle of what is seen of the opening
///
/// A flat opening has the same share of I in every element, whichever side of it the file sends light
/// to: what goes above the horizon of a panel comes from the same rectangle. A solid shines from the
/// faces that the receiver is before (measured_opening.h). The visible part of each is cut out exactly
/// and integrated by Gauss points, split where two levels disagree.
///
/// Where nothing is in between and the certificate leaves less than share_left_out_by_points, or than is
/// allowed, the opening is taken for a point, and the certificate's bound is the error.
class MeasuredSource {
public:
    /// `opening`: flat, in the luminaire's frame; `scale` is k.
    MeasuredSource(const Placement& placed, const Region& opening, Photometry photometry, double scale);
    MeasuredSource(const Placement& placed, const OpeningSolid& opening, Photometry photometry, double scale);

    /// Estimate::error: lx, by which the value may be off (opening_integral.h).
    Estimate unobstructed(const Receiver& receiver) const { return obstructed(receiver, Obstacles{}); }
    Estimate obstructed(const Receiver& receiver, const Obstacles& obstacles, const Accuracy& accuracy = {}) const;

    /// What would arrive if all of a flat opening shone from one place, nothing in between.
    double from_place(const Vec3& place, const Receiver& receiver) const;

    bool is_flat() const { return !solid_; }
    const Polygon& extent() const { return extent_; }  ///< scene coordinates
    /// Convex polygons behind whose hull nothing of the opening is: its own, or the faces of the box
    /// around a solid. Scene coordinates.
    std::vector<Polygon> pieces() const;

    /// Nothing is radiated to places behind every corner of the opening; zero: it shines all around.
    Vec3 front() const { return dark_above_ ? -placed_.rotation[2] : Vec3{0.0}; }

private:
    enum class Sight { none, partly, whole };  ///< of the opening over the receiver's horizon
    Sight sight_of(const Receiver& receiver) const;
    std::optional<Estimate> as_point(const Receiver& receiver, const Accuracy& accuracy) const;

    Placement placed_;
    std::vector<Polygon> pieces_;  ///< convex, in the luminaire's frame; empty for a solid
    std::optional<OpeningSolid> solid_;
    Polygon extent_;
    IntensityTable table_;
    PointCertificate certificate_;
    double scale_ = 0.0;
    double area_ = 0.0;            ///< m2, of the flat opening
    bool dark_above_ = false;      ///< nothing is radiated above the luminaire's own horizon
    double finest_beam_ = 1.0;     ///< rad over which the intensity changes by its peak at the fastest
    double greatest_error_ = 0.0;  ///< cd by which a point may be off
};

}  // namespace hanei
