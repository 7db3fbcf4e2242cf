#include "engine/transport/kernel_middle.h"

#include "engine/geometry/arc_tangent.h"
#include "engine/geometry/polygon.h"

#include <algorithm>
#include <cmath>

namespace hanei {

namespace {

/// A polygon whose corners are within this share of its distance is far: what four points of the kernel
/// leave out of its middle goes with the cube of it, of a skewed one with itself.
constexpr double far_reach = 0.07;
/// A receiver lower over a polygon than this share of its size lies in it.
constexpr double in_plane = 1e-10;

double kernel(const Vec3& seen, const Vec3& normal, const Vec3& front) {
    const double square = glm::dot(seen, seen);
    if (square <= 0.0) return 0.0;
    return std::max(0.0, glm::dot(seen, normal)) * std::max(0.0, -glm::dot(seen, front)) / (square * square);
}

KernelMiddle all_from(const Vec3& place, const PatchFrame& frame, double factor) {
    const Vec2 at = frame.coordinates(place);
    return {factor, at, at.x * at.y};
}

/// The light shared out by the kernel at the part's four nodes.
KernelMiddle of_far(const PatchFrame& part, const Vec3& front, const PatchFrame& frame, const Receiver& receiver,
                    double factor) {
    KernelMiddle seen{factor, Vec2{0.0}, 0.0};
    double sum = 0.0;
    for (unsigned k = 0; k < 4; ++k) {
        const double value = kernel(part.node(k) - receiver.position, receiver.normal, front);
        const Vec2 at = frame.coordinates(part.node(k));
        sum += value;
        seen.middle += value * at;
        seen.product += value * at.x * at.y;
    }
    if (!(sum > 0.0)) return all_from(part.centre, frame, factor);
    seen.middle /= sum;
    seen.product /= sum;
    return seen;
}

/// Integral of log(1 + (s^2 + d^2) / w^2) / (2 (s^2 + d^2)) ds along an edge, s = b sinh t with
/// b^2 = d^2 + w^2: Gauss's rule of four on panels, the singularities pi/2 beside the line.
double log_over_square(double from, double to, double d, double w) {
    constexpr std::array<double, 2> places = {0.3399810435848563, 0.8611363115940526};
    constexpr std::array<double, 2> weights = {0.6521451548625461, 0.3478548451374538};
    constexpr double longest = 1.0;
    const double b = std::sqrt(d * d + w * w);
    const double start = std::asinh(from / b), length = std::asinh(to / b) - start;
    const int panels = std::max(1, static_cast<int>(std::ceil(length / longest)));
    const double half = 0.5 * length / panels;
    const auto integrand = [&](double t) {
        const double s = b * std::sinh(t);
        const double z = (s * s + d * d) / (w * w);
        return (z < 1e-8 ? 1.0 - 0.5 * z : std::log1p(z) / z) * std::sqrt(s * s + b * b);
    };
    double sum = 0.0;
    for (int panel = 0; panel < panels; ++panel) {
        const double middle = start + (2.0 * panel + 1.0) * half;
        for (std::size_t k = 0; k < 2; ++k) {
            sum += weights[k] * (integrand(middle - half * places[k]) + integrand(middle + half * places[k]));
        }
    }
    return half * sum / (2.0 * w * w);
}

/// Integrals over a polygon of u^i v^j / r^4, in its plane about the receiver's foot, as sums over its
/// edges: with r^2 = u^2 + v^2 + w^2 each of them is a divergence, but for a rest of 1 / r^2.
class PlaneIntegrals {
public:
    explicit PlaneIntegrals(double w) : w_(w) {}

    void add_edge(const Vec2& from, const Vec2& to) {
        const double length = glm::length(to - from);
        if (length <= 0.0) return;
        const Vec2 e = (to - from) / length;
        const double low = glm::dot(from, e), high = low + length;
        const double d = from.x * e.y - from.y * e.x;  // of the foot, inward
        const double b = std::sqrt(d * d + w_ * w_);
        // integrals of 1, s and s^2 over s^2 + b^2
        const double plain = arc_tangent(b * length, b * b + low * high) / b;
        const double linear = 0.5 * std::log((high * high + b * b) / (low * low + b * b));
        const double square = length - b * b * plain;
        level += 0.5 * d * plain;
        u -= 0.5 * e.y * plain;
        v += 0.5 * e.x * plain;
        uu -= 0.5 * e.y * (e.x * linear + d * e.y * plain);
        vv += 0.5 * e.x * (e.y * linear - d * e.x * plain);
        uv -= 0.5 * e.y * (e.y * linear - d * e.x * plain);
        uuv += 0.5 * e.x * (e.x * e.x * square + 2.0 * d * e.x * e.y * linear + d * d * e.y * e.y * plain);
        uvv -= 0.5 * e.y * (e.y * e.y * square - 2.0 * d * e.x * e.y * linear + d * d * e.x * e.x * plain);
        const double rest = 0.5 * d * log_over_square(low, high, d, w_);
        uu += rest;
        vv += rest;
    }

    double level = 0.0;  ///< of w^2
    double u = 0.0, v = 0.0, uu = 0.0, vv = 0.0, uv = 0.0, uuv = 0.0, uvv = 0.0;

private:
    double w_;
};

/// Needs     a polygon above the horizon; a receiver `w` above its plane.
KernelMiddle of_near(const Polygon& part, const PatchFrame& frame, const Receiver& receiver, double w, double factor) {
    const Vec2 deviation{glm::length(frame.along), glm::length(frame.across)};
    const Vec3 along = frame.along / deviation.x, across = frame.across / deviation.y;
    const auto flat = [&](const Vec3& seen) { return Vec2{glm::dot(seen, along), glm::dot(seen, across)}; };
    PlaneIntegrals in(w);
    for (std::size_t k = 0; k < part.size(); ++k) {
        in.add_edge(flat(part[k] - receiver.position), flat(part[(k + 1) % part.size()] - receiver.position));
    }
    const Vec2 n = flat(receiver.normal);
    const double n_w = -glm::dot(receiver.normal, glm::cross(along, across));
    const double light = w * (n.x * in.u + n.y * in.v) + n_w * in.level;
    if (!(light > 0.0)) return all_from(centroid(part), frame, factor);
    const double light_u = w * (n.x * in.uu + n.y * in.uv + n_w * w * in.u);
    const double light_v = w * (n.x * in.uv + n.y * in.vv + n_w * w * in.v);
    const double light_uv = w * (n.x * in.uuv + n.y * in.uvv + n_w * w * in.uv);
    const Vec2 centre = flat(frame.centre - receiver.position);
    const Vec2 mean = Vec2{light_u, light_v} / light - centre;
    const double product = light_uv / light - centre.x * centre.y - centre.x * mean.y - centre.y * mean.x;
    return {factor, mean / deviation, product / (deviation.x * deviation.y)};
}

}  // namespace

KernelMiddle kernel_middle(const Polygon& polygon, const PatchFrame& frame, const Receiver& receiver) {
    const double factor = configuration_factor(polygon, receiver);
    if (factor <= 0.0) return {};
    const bool whole = is_above_horizon(polygon, receiver);
    const Polygon part = whole ? polygon : clipped(polygon, {receiver.position, receiver.normal}, 0.0);
    const Vec3 front = unit_normal(part);
    // a receiver in the polygon's plane: all its light comes from where it touches
    if (front == Vec3{0.0}) return all_from(receiver.position, frame, factor);
    const PatchFrame around = whole ? frame : frame_of(part, front, frame.along);
    const Vec3 seen = around.centre - receiver.position;
    double reach = 0.0;
    for (const Vec3& corner : part) reach = std::max(reach, glm::length(corner - around.centre));
    if (reach <= far_reach * glm::length(seen)) return of_far(around, front, frame, receiver, factor);
    const double w = -glm::dot(seen, front);
    if (w <= in_plane * reach) return all_from(receiver.position, frame, factor);
    return of_near(part, frame, receiver, w, factor);
}

bool is_above_horizon(const Polygon& polygon, const Receiver& receiver) {
    return std::all_of(polygon.begin(), polygon.end(), [&](const Vec3& corner) {
        return glm::dot(corner - receiver.position, receiver.normal) >= 0.0;
    });
}

std::array<double, 4> node_shares(const KernelMiddle& seen) {
    const double xi = std::clamp(seen.middle.x, -1.0, 1.0), eta = std::clamp(seen.middle.y, -1.0, 1.0);
    const double product = std::clamp(seen.product, std::abs(xi + eta) - 1.0, 1.0 - std::abs(xi - eta));
    const double share = 0.25 * seen.factor;
    const auto at_least_0 = [&](double value) { return share * std::max(0.0, value); };
    return {at_least_0(1.0 - xi - eta + product), at_least_0(1.0 + xi - eta - product),
            at_least_0(1.0 - xi + eta - product), at_least_0(1.0 + xi + eta + product)};
}

}  // namespace hanei
