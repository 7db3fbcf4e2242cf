/// A luminous opening every element of which radiates a measured distribution.
#pragma once

#include "engine/direct/intensity_table.h"
#include "engine/direct/obstacles.h"
#include "engine/geometry/configuration_factor.h"
#include "engine/scene/placement.h"
#include "engine/scene/scene.h"

#include <span>
#include <vector>

namespace hanei {

/// An element dA at x gives  k I(direction) cos(theta) / (A r^2) dA:  the luminance k I / (A cos) of
/// the near-field model, I the file's intensity in the luminaire's frame. The visible part of the
/// opening is cut out exactly and integrated by Gauss points, split where two levels disagree.
class MeasuredSource {
public:
    /// `opening` in scene coordinates; `scale` is k.
    MeasuredSource(const Placement& placed, const Region& opening, Photometry photometry, double scale);

    double unobstructed(const Receiver& receiver) const { return obstructed(receiver, Obstacles{}); }
    double obstructed(const Receiver& receiver, const Obstacles& obstacles) const;

    const Polygon& outline() const { return outline_; }
    std::span<const Polygon> pieces() const { return pieces_; }  ///< convex

    /// Nothing is radiated to places behind every corner of the opening; zero: it shines all around.
    Vec3 front() const { return dark_above_ ? -rotation_[2] : Vec3{0.0}; }

private:
    bool may_light(const Receiver& receiver) const;

    Mat3 rotation_;
    std::vector<Polygon> pieces_;  ///< convex
    Polygon outline_;
    IntensityTable table_;
    double scale_over_area_ = 0.0;
    bool dark_above_ = false;   ///< nothing is radiated above the luminaire's own horizon
    double finest_beam_ = 1.0;  ///< rad over which the intensity changes by its peak at the fastest
};

}  // namespace hanei
