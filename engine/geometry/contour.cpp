#include "engine/geometry/contour.h"

#include "engine/base/tolerance.h"
#include "engine/geometry/arc_tangent.h"
#include "engine/geometry/configuration_factor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace hanei {

namespace {

constexpr double far_ratio = 0.05;        // degree 8 leaves 1e-13 of F at this size over distance
constexpr double very_far_ratio = 0.003;  // degree 5 leaves 1e-15

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

struct RulePoint {
    double weight, a, b;  ///< weights add up to 1; the third coordinate is 1 - a - b
};

// Symmetric Gauss rules on the triangle: degree 5 (Radon 1948), degree 8 (Dunavant 1985).
constexpr std::array<RulePoint, 7> degree_5 = {{{0.225, 1.0 / 3.0, 1.0 / 3.0},
                                                {0.132394152788506, 0.470142064105115, 0.470142064105115},
                                                {0.132394152788506, 0.470142064105115, 0.059715871789770},
                                                {0.132394152788506, 0.059715871789770, 0.470142064105115},
                                                {0.125939180544827, 0.101286507323456, 0.101286507323456},
                                                {0.125939180544827, 0.101286507323456, 0.797426985353087},
                                                {0.125939180544827, 0.797426985353087, 0.101286507323456}}};
constexpr std::array<RulePoint, 16> degree_8 = {{{0.144315607677787, 1.0 / 3.0, 1.0 / 3.0},
                                                 {0.095091634267285, 0.459292588292723, 0.459292588292723},
                                                 {0.095091634267285, 0.459292588292723, 0.081414823414554},
                                                 {0.095091634267285, 0.081414823414554, 0.459292588292723},
                                                 {0.103217370534718, 0.170569307751760, 0.170569307751760},
                                                 {0.103217370534718, 0.170569307751760, 0.658861384496480},
                                                 {0.103217370534718, 0.658861384496480, 0.170569307751760},
                                                 {0.032458497623198, 0.050547228317031, 0.050547228317031},
                                                 {0.032458497623198, 0.050547228317031, 0.898905543365938},
                                                 {0.032458497623198, 0.898905543365938, 0.050547228317031},
                                                 {0.027230314174435, 0.008394777409958, 0.263112829634638},
                                                 {0.027230314174435, 0.263112829634638, 0.008394777409958},
                                                 {0.027230314174435, 0.728492392955404, 0.263112829634638},
                                                 {0.027230314174435, 0.263112829634638, 0.728492392955404},
                                                 {0.027230314174435, 0.728492392955404, 0.008394777409958},
                                                 {0.027230314174435, 0.008394777409958, 0.728492392955404}}};

/// cos cos / (pi r^2) over a fan of triangles: for loops so small and far that the contour sum
/// would cancel.
template <std::size_t Points>
double far_factor(const SeenLoop& loop, const Vec3& normal, const std::array<RulePoint, Points>& rule) {
    double sum = 0.0;
    for (std::size_t k = 2; k < loop.size(); ++k) {
        const Vec3& u = loop.offsets[k - 1];
        const Vec3& v = loop.offsets[k];
        const Vec3 area = 0.5 * glm::cross(u, v);
        const double to_plane = -glm::dot(area, loop.first);
        double triangle = 0.0;
        for (const RulePoint& point : rule) {
            const Vec3 seen = loop.first + point.a * u + point.b * v;
            const double square = glm::dot(seen, seen);
            triangle += point.weight * glm::dot(seen, normal) / (square * square);
        }
        sum += triangle * to_plane;
    }
    return sum / std::numbers::pi;
}

double factor_above_horizon(const SeenLoop& loop, const Vec3& normal) {
    Vec3 low = loop.offsets[0];
    Vec3 high = low;
    for (const Vec3& offset : loop.offsets) {
        low = glm::min(low, offset);
        high = glm::max(high, offset);
    }
    const double size = glm::length(high - low);
    const double distance = glm::length(loop.first + 0.5 * (low + high));
    if (size < very_far_ratio * distance) return far_factor(loop, normal, degree_5);
    if (size < far_ratio * distance) return far_factor(loop, normal, degree_8);

    double sum = 0.0;
    Vec3 a = loop.point(loop.size() - 1);
    Vec3 offset_a = loop.offsets[loop.size() - 1];
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec3 b = loop.point(k);
        sum += edge_share(a, b, loop.offsets[k] - offset_a, normal);
        a = b;
        offset_a = loop.offsets[k];
    }
    return sum / (2.0 * std::numbers::pi);
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
