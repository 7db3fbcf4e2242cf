/// From how far a measured luminaire may be taken for a point, and what that costs at most.
#pragma once

#include "engine/base/vector.h"
#include "engine/scene/angular_change.h"
#include "engine/scene/opening_shape.h"
#include "engine/scene/photometry.h"

#include <span>

namespace hanei {

/// Share of the peak that direct light lets the point model leave out: an opening nearer than its
/// certificate allows for this is integrated over.
inline constexpr double share_left_out_by_points = 1e-4;

/// What of an opening's form counts from afar, about its centre.
struct OpeningForm {
    Vec3 centre{0.0};            ///< in the luminaire's frame
    double radius = 0.0;         ///< m, of the ball that holds the opening; 0: a point
    double mean_distance = 0.0;  ///< m, root of the mean square
    double spread = 0.0;         ///< m, the greatest standard deviation along a line
    bool level = false;          ///< flat, and square to the luminaire's vertical
    bool solid = false;          ///< a box, cylinder or ellipsoid: it looks different from every side
    bool angular = false;        ///< a box, whose sides may be luminous in part
    double unevenness = 0.0;     ///< 1/rad, of a solid: the greatest change of the projected area over the least area
    double depth = 0.0;          ///< m, of a box: sides' areas times their distance from the centre, over the least
};
OpeningForm form_of(const MeasuredOpeningSize& size);
OpeningForm form_of(const OpeningSolid& solid);
OpeningForm form_of(std::span<const Polygon> flat_pieces);  ///< convex, in one plane

/// A bound, proved from the table, on what the point model leaves out: an opening every element of
/// which radiates the file's intensity, against all of it from the opening's centre.
///
///     | E - I cos / d2 |  <=  bound(d) x peak / d2      d: from the centre of the opening
///
/// in every direction. For flat openings the parts that are odd about the centroid cancel, so that it
/// falls with the square of size / d until the steps of slope between the table's angles take over,
/// which fall with size / d; for solids it falls with size / d, as the error itself does.
///
/// Needs     the whole opening above the receiver's horizon and nothing in between.
/// Holds     for the bilinear table, whatever it stands for. Never less than the true difference;
///           3 to 10 times the greatest over all directions for rotational files on flat openings, some 20
///           times for others, more for solids.
/// Weak when a file ends at an angle where it still shines, or its planes disagree at a pole: then no
///           distance is far enough for a bound below that jump.
/// Cost      as much to make as looking at every figure a few times; error() 0.1 us, bound() 50 us.
class PointCertificate {
public:
    explicit PointCertificate(const Photometry& photometry);  ///< the opening of the file
    PointCertificate(const Photometry& photometry, const OpeningForm& opening);

    const OpeningForm& opening() const { return opening_; }

    /// Share of peak intensity / d2 by which the two differ at most; never rises with the distance.
    /// Infinite within twice the opening's radius. 0 for a point.
    double bound(double distance) const;

    /// Least distance from which bound() is at most `share`; infinity when none within 1e4 radii is.
    double distance_for(double share) const;

    /// The same for one direction: candela by which E d2 and `intensity` x `cosine` differ at most.
    /// `direction`, in the luminaire's frame and of any length, is the one of `intensity`; `cosine`
    /// that of the receiver.
    double error(const Vec3& direction, double distance, double intensity, double cosine) const;

private:
    double flat(const AngularChange& change, double ratio, double intensity, double cosine) const;
    double solid(const AngularChange& change, double distance, double intensity, double cosine) const;
    double least_weight(double distance) const;

    OpeningForm opening_;
    AngularChanges changes_;
    double peak_ = 0.0;
};

}  // namespace hanei
