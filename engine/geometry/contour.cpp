#include "engine/geometry/contour.h"

#include "engine/base/tolerance.h"
#include "engine/geometry/arc_tangent.h"
#include "engine/geometry/configuration_factor.h"
#include "engine/geometry/edge_sums.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace hanei {

namespace {

/// Corners nearer to their middle than this share of its distance: the plain sum loses the square of
/// its inverse, and takes half the time.
constexpr double far_reach = 0.5;

/// Room for a clipped loop; on the stack for the sizes that occur in rooms.
class Clipping {
public:
    explicit Clipping(std::size_t corners) {
        if (2 * corners > few_.size()) many_.resize(2 * corners);
        points_ = many_.empty() ? few_.data() : many_.data();
    }
    void add(const Vec3& point) { points_[count_++] = point; }
    std::span<Vec3> points() { return {points_, count_}; }

private:
    std::array<Vec3, 64> few_;
    std::vector<Vec3> many_;
    Vec3* points_ = nullptr;
    std::size_t count_ = 0;
};

/// One edge's share, 2 pi times: angle times normal . (b x a) / |b x a|.
double edge_share(const Vec3& a, const Vec3& b, const Vec3& edge, const Vec3& normal) {
    const Vec3 across = glm::cross(edge, a);
    const double square = glm::dot(across, across);
    if (square == 0.0) return 0.0;
    return glm::dot(across, normal) * angle_over_cross(square, glm::dot(a, b));
}

double factor_above_horizon(const SeenLoop& loop, const Vec3& normal) {
    Vec3 middle{0.0};
    for (const Vec3& offset : loop.offsets) middle += offset;
    middle /= static_cast<double>(loop.size());
    double reach = 0.0;
    for (const Vec3& offset : loop.offsets) reach = std::max(reach, glm::dot(offset - middle, offset - middle));
    const Vec3 seen_middle = loop.first + middle;
    const bool far = reach < far_reach * far_reach * glm::dot(seen_middle, seen_middle);
    return far ? far_sum(loop, middle, seen_middle, normal) : near_sum(loop, normal);
}

/// Sutherland and Hodgman's clip by the horizon; an outline that is not convex gets edges that run
/// to and fro on the horizon and cancel in the sum.
void clip_at_horizon(std::span<const Vec3> points, std::span<const double> heights, Clipping& kept) {
    for (std::size_t k = 0; k < points.size(); ++k) {
        const std::size_t next = (k + 1) % points.size();
        if (heights[k] >= 0.0) kept.add(points[k]);
        if ((heights[k] > 0.0 && heights[next] < 0.0) || (heights[k] < 0.0 && heights[next] > 0.0)) {
            kept.add(points[k] + (heights[k] / (heights[k] - heights[next])) * (points[next] - points[k]));
        }
    }
}

/// Heights over the horizon, on the stack for usual loops.
class Heights {
public:
    explicit Heights(std::size_t count) : count_(count) {
        if (count > few_.size()) many_.resize(count);
    }
    std::span<double> all() { return {many_.empty() ? few_.data() : many_.data(), count_}; }

private:
    std::array<double, 32> few_;
    std::vector<double> many_;
    std::size_t count_;
};

}  // namespace

double touching_distance(const Receiver& receiver, double farthest_corner) {
    const Vec3 place = glm::abs(receiver.position);
    const double rounding = 8.0 * std::numeric_limits<double>::epsilon() * std::max({place.x, place.y, place.z});
    const double share = receiver.inward == Vec3{0.0} ? tolerance::touching : tolerance::same_place;
    return share * farthest_corner + rounding;
}

double contour_factor(const SeenLoop& loop, const Vec3& normal) {
    if (loop.size() < 3) return 0.0;
    Heights heights(loop.size());
    const double first = glm::dot(loop.first, normal);
    double lowest = first, highest = first;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const double height = first + glm::dot(loop.offsets[k], normal);
        heights.all()[k] = height;
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
    }
    if (highest <= 0.0) return 0.0;
    if (lowest >= 0.0) return factor_above_horizon(loop, normal);

    Clipping kept(loop.size());
    clip_at_horizon(loop.offsets, heights.all(), kept);
    if (kept.points().size() < 3) return 0.0;
    const Vec3 start = kept.points()[0];
    for (Vec3& offset : kept.points()) offset -= start;
    return factor_above_horizon({loop.first + start, kept.points()}, normal);
}

double contour_limit(const SeenLoop& loop, const Vec3& normal, const Vec3& plane, const Vec3& beside, double touching) {
    if (loop.size() < 3) return 0.0;
    std::vector<Vec3> points(loop.size());
    Heights heights(loop.size());
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec3 point = loop.point(k);
        points[k] = point - glm::dot(point, plane) * plane;
        if (glm::length(points[k]) <= touching) points[k] = Vec3{0.0};
        const double height = glm::dot(points[k], normal);
        heights.all()[k] = std::abs(height) <= touching ? 0.0 : height;
    }
    Clipping kept(loop.size());
    clip_at_horizon(points, heights.all(), kept);

    double sum = 0.0;
    const std::span<const Vec3> corners = kept.points();
    for (std::size_t k = 0; k < corners.size(); ++k) {
        Vec3 a = corners[k];
        Vec3 b = corners[(k + 1) % corners.size()];
        if (a == b) continue;
        // The corner as it is seen just before the origin is reached, be it the polygon's own or cut
        // by the horizon.
        if (glm::length(a) <= touching) a = -beside;
        if (glm::length(b) <= touching) b = -beside;
        const Vec3 edge = b - a;
        const Vec3 across = glm::cross(edge, a);
        if (glm::length(across) > touching * glm::length(edge)) {
            sum += edge_share(a, b, edge, normal);
        } else if (glm::dot(a, b) < 0.0) {  // the origin is on the edge: it spans half a turn
            const Vec3 limit = glm::cross(beside, edge);
            sum += std::numbers::pi * glm::dot(limit, normal) / glm::length(limit);
        }
    }
    return sum / (2.0 * std::numbers::pi);
}

}  // namespace hanei
