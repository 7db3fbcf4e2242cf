#include "engine/geometry/visible_pieces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace hanei {

namespace {

// Heights over a plane through the eye carry a rounding of about 1e-16 of the distance; a hundred
// times that keeps cuts through existing corners from making slivers.
constexpr double relative_rounding = 1e-14;

/// From here on it pays to hold a ball around a piece against a plane before its points.
constexpr std::size_t many = 4;

double size_of(const Vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

}  // namespace

void VisiblePieces::measure(Range& piece) const {
    const std::span<const Vec3> points = points_of(piece);
    piece.centre = Vec3{0.0};
    for (const Vec3& point : points) piece.centre += point;
    piece.centre /= static_cast<double>(std::max<std::size_t>(points.size(), 1));
    double square = 0.0;
    for (const Vec3& point : points) square = std::max(square, glm::dot(point - piece.centre, point - piece.centre));
    piece.radius = std::sqrt(square);
}

void VisiblePieces::start(std::span<const Vec3> seen) {
    points_.assign(seen.begin(), seen.end());
    pieces_.assign(1, Range{0, points_.size()});
    untouched_ = true;
    double farthest = 0.0;
    for (const Vec3& point : seen) farthest = std::max(farthest, size_of(point));
    rounding_ = relative_rounding * farthest;
}

void VisiblePieces::prepare(std::span<const HalfSpace> hidden) {
    planes_.clear();
    for (const HalfSpace& plane : hidden) {
        const double size = size_of(plane.outward);
        planes_.push_back(
            {plane.outward, plane.reach, size, rounding_ * size, std::max(plane.slack, rounding_ * size)});
    }
    if (pieces_.size() >= many) std::ranges::stable_sort(planes_, std::greater{}, &Plane::size);
}

/// Writes a piece's heights over the plane; says what part of it lies beyond.
VisiblePieces::Side VisiblePieces::side_of(std::span<const Vec3> piece, const Plane& plane) {
    heights_.resize(piece.size());
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (std::size_t k = 0; k < piece.size(); ++k) {
        const double height = glm::dot(plane.outward, piece[k]) - plane.reach;
        heights_[k] = height;
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
    }
    if (lowest >= -plane.slack) return Side::outside;
    return highest > plane.rounding ? Side::both : Side::inside;
}

/// Collects the planes that cut the piece; false when it loses nothing.
bool VisiblePieces::find_cuts(Range& piece) {
    if (pieces_.size() >= many) {
        if (piece.radius < 0.0) measure(piece);
        const bool beyond = std::ranges::any_of(planes_, [&](const Plane& plane) {
            return glm::dot(plane.outward, piece.centre) - plane.reach >= piece.radius * plane.size;
        });
        if (beyond) return false;
    }
    cuts_.clear();
    for (const Plane& plane : planes_) {
        const Side side = side_of(points_of(piece), plane);
        if (side == Side::outside) return false;
        if (side == Side::both) cuts_.push_back(&plane);
    }
    return true;
}

void VisiblePieces::subtract(std::span<const HalfSpace> hidden) {
    prepare(hidden);
    std::size_t whole = 0;
    while (whole < pieces_.size() && !find_cuts(pieces_[whole])) ++whole;
    if (whole == pieces_.size()) return;

    next_points_.clear();
    next_pieces_.clear();
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
        if (k < whole || (k > whole && !find_cuts(pieces_[k]))) {
            keep(pieces_[k]);
        } else {
            cut(pieces_[k]);
        }
    }
    points_.swap(next_points_);
    pieces_.swap(next_pieces_);
}

void VisiblePieces::keep(const Range& piece) {
    const std::span<const Vec3> points = points_of(piece);
    next_pieces_.push_back({next_points_.size(), piece.count, piece.centre, piece.radius});
    next_points_.insert(next_points_.end(), points.begin(), points.end());
}

/// Splits off what is outside of one plane after another; what is inside all of them is hidden. Long
/// edges first: what a thin body's ends then split off is narrow, and seldom cut again.
void VisiblePieces::cut(const Range& piece) {
    for (std::size_t k = 1; k < cuts_.size(); ++k) {  // few, and equals keep their order
        for (std::size_t j = k; j > 0 && cuts_[j - 1]->size < cuts_[j]->size; --j) std::swap(cuts_[j - 1], cuts_[j]);
    }
    const std::size_t points_before = next_points_.size();
    const std::size_t pieces_before = next_pieces_.size();
    rest_.assign(points_of(piece).begin(), points_of(piece).end());
    for (const Plane* plane : cuts_) {
        const Side side = side_of(rest_, *plane);
        if (side == Side::outside) {  // nothing is hidden after all: no cuts
            next_points_.resize(points_before);
            next_pieces_.resize(pieces_before);
            keep(piece);
            return;
        }
        if (side == Side::both) split_rest(plane->rounding);
    }
    untouched_ = false;
}

/// Keeps the part of `rest_` outside the plane as a piece; the part behind it becomes `rest_`.
void VisiblePieces::split_rest(double on_plane) {
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
