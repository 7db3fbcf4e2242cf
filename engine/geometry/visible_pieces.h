/// A convex polygon seen from an eye, cut into the convex pieces that remain visible.
#pragma once

#include "engine/geometry/hidden_region.h"

#include <span>
#include <vector>

namespace hanei {

/// Holds     its memory from one use to the next: keep one a thread.
class VisiblePieces {
public:
    /// Begins anew with one piece; points are seen from the eye.
    void start(std::span<const Vec3> seen);

    /// Takes away what lies inside all half-spaces. Pieces that would lose nothing stay whole.
    void subtract(std::span<const HalfSpace> hidden);

    bool empty() const { return pieces_.empty(); }
    bool untouched() const { return untouched_; }
    std::size_t size() const { return pieces_.size(); }
    std::span<const Vec3> operator[](std::size_t k) const { return points_of(pieces_[k]); }

private:
    struct Range {
        std::size_t first = 0, count = 0;
        Vec3 centre{0.0};      ///< of a ball that holds the points
        double radius = -1.0;  ///< below zero: not measured yet
    };
    struct Plane {
        Vec3 outward;
        double reach;
        double size;      ///< of its direction, no less than its length
        double rounding;  ///< of heights over it
        double slack;     ///< a place must be deeper than this to be inside
    };
    enum class Side { inside, both, outside };

    std::span<const Vec3> points_of(const Range& piece) const { return {points_.data() + piece.first, piece.count}; }
    void measure(Range& piece) const;
    void prepare(std::span<const HalfSpace> hidden);
    Side side_of(std::span<const Vec3> piece, const Plane& plane);
    bool find_cuts(Range& piece);
    void cut(const Range& piece);
    void split_rest(double on_plane);
    void keep(const Range& piece);

    std::vector<Vec3> points_, next_points_, rest_, inside_;
    std::vector<Range> pieces_, next_pieces_;
    std::vector<Plane> planes_;
    std::vector<const Plane*> cuts_;
    std::vector<double> heights_;
    double rounding_ = 0.0;
    bool untouched_ = true;
};

}  // namespace hanei
