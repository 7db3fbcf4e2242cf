/// How fast the intensity of a table can change with direction, at most.
#pragma once

#include "engine/base/vector.h"
#include "engine/scene/photometry.h"

#include <numbers>
#include <vector>

namespace hanei {

/// Bounds for some directions and all others within an angle of them. The bilinear table is seen
/// from its own poles (types A and C: the vertical, B: the y axis): rings of equal colatitude, each
/// piecewise linear around.
struct AngularChange {
    double slope = 0.0;      ///< cd/rad along any great circle
    double kinks = 0.0;      ///< cd/rad: the slope's steps at rings, those at the way's end counting nothing
    double bends = 0.0;      ///< cd/rad: the same at meridians
    double curvature = 0.0;  ///< cd/rad2 between the steps; infinite about a pole, as kinks and bends are
    double jump = 0.0;       ///< cd: at the end of the table's range, or at a pole where planes disagree
    double lean = 1.0;       ///< greatest cosine of the angle to the vertical among them all; 1 where not known
    double turning = 0.0;    ///< how much of its bearing a great circle may turn on the way, 0 to 1
    double greatest = 0.0;   ///< cd: the greatest intensity of the directions meant, not of those around
};

/// Needs     a table that hangs together (intensity.h).
/// Holds     what is greatest around each ring and over each zone between two.
/// Cost      as much as looking at every figure thrice; a question as much as it meets rings.
class AngularChanges {
public:
    explicit AngularChanges(const Photometry& photometry);

    /// Of a direction in the luminaire's frame, any length; rad from the table's first pole.
    double colatitude(const Vec3& direction) const;
    /// Directions of colatitude `low` to `high` and all within `angle` of them.
    AngularChange over(double low, double high, double angle) const;

private:
    struct Ring {
        double colatitude = 0.0;
        double greatest = 0.0;  ///< cd
        double step = 0.0;      ///< cd/rad, the greatest step of the slope along meridians
    };
    struct Zone {
        double low = 0.0, high = 0.0;  ///< rad of colatitude
        double slope = 0.0;            ///< cd/rad, the greatest along a meridian
        double sideways = 0.0;         ///< cd/rad, the greatest along a ring
        double bend = 0.0;             ///< cd/rad, the greatest step of that
        double twist = 0.0;            ///< cd/rad2: change of the slope along meridians with the longitude
    };
    /// The table's end, or its pole.
    struct End {
        double jump = 0.0;   ///< cd
        double stops = 0.0;  ///< cd/rad: what goes along the end and stops there
        double reach = 0.0;  ///< colatitude up to which, or from which, these are felt
    };
    struct Row;
    static std::vector<Row> rows_of(const Photometry& photometry);
    void measure_around(std::vector<Row>& rows, const Photometry& photometry);
    void measure_along(const std::vector<Row>& rows);
    End end_at(const Row& row, bool first);

    Vec3 pole_;
    bool upright_ = true;  ///< the pole is the vertical
    std::vector<Ring> rings_;
    std::vector<Zone> zones_;
    End first_, last_;
    double jump_everywhere_ = 0.0;               ///< at the ends of longitudes that do not go around
    double least_gap_ = 2.0 * std::numbers::pi;  ///< rad, between two meridians of the table
};

}  // namespace hanei
