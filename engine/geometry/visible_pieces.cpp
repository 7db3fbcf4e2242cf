#include "engine/geometry/visible_pieces.h"

#include <algorithm>
#include <cmath>

namespace hanei {

namespace {

// Heights over a plane through the eye carry a rounding of about 1e-16 of the distance; a hundred
// times that keeps cuts through existing corners from making slivers.
constexpr double relative_rounding = 1e-14;

double size_of(const Vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

}  // namespace

void VisiblePieces::start(std::span<const Vec3> seen) {
    points_.assign(seen.begin(), seen.end());
    pieces_.assign(1, Range{0, seen.size()});
    untouched_ = true;
    double farthest = 0.0;
    for (const Vec3& point : seen) farthest = std::max(farthest, size_of(point));
    rounding_ = relative_rounding * farthest;
}

double VisiblePieces::slack_of(const HalfSpace& plane) const {
    return std::max(plane.slack, rounding_ * size_of(plane.outward));
}

bool VisiblePieces::loses_nothing(std::span<const Vec3> piece, std::span<const HalfSpace> hidden) const {
    return std::ranges::any_of(hidden, [&](const HalfSpace& plane) {
        const double deepest = plane.reach - slack_of(plane);
        return std::ranges::all_of(piece, [&](const Vec3& p) { return glm::dot(plane.outward, p) >= deepest; });
    });
}

void VisiblePieces::subtract(std::span<const HalfSpace> hidden) {
    std::size_t whole = 0;
    while (whole < pieces_.size() && loses_nothing((*this)[whole], hidden)) ++whole;
    if (whole == pieces_.size()) return;

    next_points_.clear();
    next_pieces_.clear();
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
        if (k < whole || (k > whole && loses_nothing((*this)[k], hidden))) {
            keep((*this)[k]);
        } else {
            cut((*this)[k], hidden);
        }
    }
    points_.swap(next_points_);
    pieces_.swap(next_pieces_);
}

void VisiblePieces::keep(std::span<const Vec3> piece) {
    next_pieces_.push_back({next_points_.size(), piece.size()});
    next_points_.insert(next_points_.end(), piece.begin(), piece.end());
}

/// Splits off what is outside of one plane after another; what is inside all of them is hidden.
void VisiblePieces::cut(std::span<const Vec3> piece, std::span<const HalfSpace> hidden) {
    const std::size_t points_before = next_points_.size();
    const std::size_t pieces_before = next_pieces_.size();
    rest_.assign(piece.begin(), piece.end());
    for (const HalfSpace& plane : hidden) {
        double deepest = 0.0;
        heights_.clear();
        for (const Vec3& point : rest_) {
            heights_.push_back(glm::dot(plane.outward, point) - plane.reach);
            deepest = std::min(deepest, heights_.back());
        }
        if (deepest >= -slack_of(plane)) {  // nothing is hidden after all: no cuts
            next_points_.resize(points_before);
            next_pieces_.resize(pieces_before);
            keep(piece);
            return;
        }
        split_rest(rounding_ * size_of(plane.outward));
    }
    untouched_ = false;
}

/// Keeps the part of `rest_` outside the plane as a piece; the part behind it becomes `rest_`.
void VisiblePieces::split_rest(double on_plane) {
    if (std::ranges::none_of(heights_, [&](double height) { return height > on_plane; })) return;
    inside_.clear();
    const std::size_t first = next_points_.size();
    for (std::size_t k = 0; k < rest_.size(); ++k) {
        const std::size_t next = k + 1 < rest_.size() ? k + 1 : 0;
        const double here = heights_[k], there = heights_[next];
        if (here >= -on_plane) next_points_.push_back(rest_[k]);
        if (here <= on_plane) inside_.push_back(rest_[k]);
        if ((here > on_plane && there < -on_plane) || (here < -on_plane && there > on_plane)) {
            const Vec3 crossing = rest_[k] + (here / (here - there)) * (rest_[next] - rest_[k]);
            next_points_.push_back(crossing);
            inside_.push_back(crossing);
        }
    }
    next_pieces_.push_back({first, next_points_.size() - first});
    rest_.swap(inside_);
}

}  // namespace hanei
