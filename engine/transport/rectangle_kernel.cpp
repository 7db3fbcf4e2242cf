#include "engine/transport/rectangle_kernel.h"

#include "engine/geometry/quartet_angle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hanei {

namespace {

/// From low to high along one side, as the receiver sees it.
struct Span {
    double low, high;
    HANEI_QUARTET double length() const { return high - low; }
};

/// Differences of arc tangent (x / b) at the ends of spans of x.
HANEI_QUARTET Quartet angles_of(const Quartet& low, const Quartet& high, const Quartet& b) {
    return angles_above(b * (high - low), b * b + low * high);
}

/// Integral of 1 / (u^2 + v^2 + w^2), along u = w sinh t by Gauss's rule of four on panels: the
/// singularities are pi/2 beside the line, three times as far as half a panel is long.
HANEI_QUARTET double inverse_square(const Span& u, const Span& v, double w) {
    constexpr double inner = 0.3399810435848563, outer = 0.8611363115940526;
    constexpr Quartet weights = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538};
    constexpr double longest = 1.0;
    const auto exponential = [&](double x) {  // of t, without cancellation
        const double r = std::sqrt(x * x + w * w);
        return x < 0.0 ? w / (r - x) : (r + x) / w;
    };
    const double start = exponential(u.low);
    const double length = std::log(exponential(u.high) / start);
    const int panels = std::max(1, static_cast<int>(std::ceil(length / longest)));
    const double half = 0.5 * length / panels;
    const double near = std::exp(half * inner), far = std::exp(half * outer), panel_long = std::exp(half);
    const Quartet steps = {1.0 / far, 1.0 / near, near, far};
    const Quartet low = quartet(v.low), high = quartet(v.high);
    Quartet sum = quartet(0.0);
    double middle = start * panel_long;
    for (int panel = 0; panel < panels; ++panel) {
        const Quartet e = middle * steps;
        sum += weights * angles_of(low, high, (0.5 * w) * (e + 1.0 / e));
        middle *= panel_long * panel_long;
    }
    return half * sum_of(sum);
}

/// The rectangle in coordinates along its sides with the receiver above their origin.
struct SeenRectangle {
    Span u{}, v{};
    Vec2 centre{0.0}, deviation{0.0};
    double w = 0.0, n_u = 0.0, n_v = 0.0, n_w = 0.0;  ///< the third towards the rectangle's plane
    Quartet far{};    ///< distances of the lines of its sides: u low, u high, v low, v high
    Quartet angle{};  ///< that the sides subtend, over the distances

    HANEI_QUARTET SeenRectangle(const PatchFrame& frame, const Receiver& receiver) {
        deviation = {glm::length(frame.along), glm::length(frame.across)};
        const Vec3 along = frame.along / deviation.x, across = frame.across / deviation.y;
        const Vec3 front = glm::cross(along, across);
        const Vec3 seen = frame.centre - receiver.position;
        centre = {glm::dot(seen, along), glm::dot(seen, across)};
        w = -glm::dot(seen, front);
        const Vec2 half = std::numbers::sqrt3 * deviation;
        u = {centre.x - half.x, centre.x + half.x};
        v = {centre.y - half.y, centre.y + half.y};
        n_u = glm::dot(receiver.normal, along);
        n_v = glm::dot(receiver.normal, across);
        n_w = -glm::dot(receiver.normal, front);

        const Quartet sides = {u.low, u.high, v.low, v.high};
        far = root(sides * sides + w * w);
        angle = angles_of(Quartet{v.low, v.low, u.low, u.low}, Quartet{v.high, v.high, u.high, u.high}, far) / far;
    }

    /// Integrals over r^4 of w^2, u, v, u v, u^2 v and u v^2.
    HANEI_QUARTET double sides_u() const { return u.high * angle[1] - u.low * angle[0]; }
    HANEI_QUARTET double sides_v() const { return v.high * angle[3] - v.low * angle[2]; }
    HANEI_QUARTET double plain() const { return 0.5 * (sides_u() + sides_v()); }
    HANEI_QUARTET double first_u() const { return 0.5 * (angle[0] - angle[1]); }
    HANEI_QUARTET double first_v() const { return 0.5 * (angle[2] - angle[3]); }
    HANEI_QUARTET double second_uv() const {
        const auto square = [&](double x, double y) { return x * x + y * y + w * w; };
        const double same = square(u.low, v.low) * square(u.high, v.high);
        const double other = square(u.low, v.high) * square(u.high, v.low);
        return 0.25 * std::log(other / same);
    }
    HANEI_QUARTET double third_uuv() const { return 0.5 * (far[3] * far[3] * angle[3] - far[2] * far[2] * angle[2]); }
    HANEI_QUARTET double third_uvv() const { return 0.5 * (far[1] * far[1] * angle[1] - far[0] * far[0] * angle[0]); }

    /// pi times the form factor.
    HANEI_QUARTET double light() const { return w * (n_u * first_u() + n_v * first_v()) + n_w * plain(); }
};

HANEI_QUARTET double factor_by(const PatchFrame& frame, const Receiver& receiver) {
    return SeenRectangle(frame, receiver).light() / std::numbers::pi;
}

HANEI_QUARTET KernelMiddle middle_by(const PatchFrame& frame, const Receiver& receiver) {
    const SeenRectangle r(frame, receiver);
    KernelMiddle seen;
    const double light = r.light();
    if (!(light > 0.0)) return seen;
    seen.factor = std::min(1.0, light / std::numbers::pi);
    double square = 0.0;
    if (std::abs(r.n_u) + std::abs(r.n_v) > 1e-12) {  // else the rectangle lies level before the receiver
        const bool along_u = r.u.length() < r.v.length();
        square = along_u ? inverse_square(r.u, r.v, r.w) : inverse_square(r.v, r.u, r.w);
    }
    const double uu = 0.5 * (square - r.sides_u()), vv = 0.5 * (square - r.sides_v()), uv = r.second_uv();
    const double light_u = r.w * (r.n_u * uu + r.n_v * uv + r.n_w * r.w * r.first_u());
    const double light_v = r.w * (r.n_u * uv + r.n_v * vv + r.n_w * r.w * r.first_v());
    const double light_uv = r.w * (r.n_u * r.third_uuv() + r.n_v * r.third_uvv() + r.n_w * r.w * uv);

    const Vec2 mean = Vec2{light_u, light_v} / light - r.centre;
    seen.middle = mean / r.deviation;
    const double about_foot = light_uv / light - r.centre.x * r.centre.y;
    seen.product = (about_foot - r.centre.x * mean.y - r.centre.y * mean.x) / (r.deviation.x * r.deviation.y);
    return seen;
}

#if defined(__x86_64__)
#define HANEI_WIDE [[gnu::target("avx2")]]
const bool wide_registers = __builtin_cpu_supports("avx2");
#else
#define HANEI_WIDE
constexpr bool wide_registers = false;
#endif

HANEI_WIDE double factor_wide(const PatchFrame& frame, const Receiver& receiver) { return factor_by(frame, receiver); }
HANEI_WIDE KernelMiddle middle_wide(const PatchFrame& frame, const Receiver& receiver) {
    return middle_by(frame, receiver);
}

}  // namespace

double rectangle_factor(const PatchFrame& frame, const Receiver& receiver) {
    const double factor = wide_registers ? factor_wide(frame, receiver) : factor_by(frame, receiver);
    return std::clamp(factor, 0.0, 1.0);
}

KernelMiddle rectangle_middle(const PatchFrame& frame, const Receiver& receiver) {
    return wide_registers ? middle_wide(frame, receiver) : middle_by(frame, receiver);
}

}  // namespace hanei
