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
    std::span<const Vec3> operator[](std::size_t k) const {
        return {points_.data() + pieces_[k].first, pieces_[k].count};
    }

private:
    struct Range {
        std::size_t first = 0, count = 0;
    };
    double slack_of(const HalfSpace& plane) const;
    bool loses_nothing(std::span<const Vec3> piece, std::span<const HalfSpace> hidden) const;
    void cut(std::span<const Vec3> piece, std::span<const HalfSpace> hidden);
    void split_rest(double on_plane);
    void keep(std::span<const Vec3> piece);

    std::vector<Vec3> points_, next_points_, rest_, inside_;
    std::vector<Range> pieces_, next_pieces_;
    std::vector<double> heights_;
    double rounding_ = 0.0;
    bool untouched_ = true;
};

}  // namespace hanei
