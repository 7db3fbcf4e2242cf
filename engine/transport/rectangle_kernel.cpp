#include "engine/transport/rectangle_kernel.h"

#include "engine/geometry/arc_tangent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hanei {

namespace {

/// From low to high along one side, as the receiver sees it.
struct Span {
    double low, high;
    double length() const { return high - low; }
};

/// Difference of arc tangent (x / b) at the ends of a span.
double angle_of(const Span& x, double b) { return arc_tangent(b * x.length(), b * b + x.low * x.high); }

/// Integral of 1 / (u^2 + v^2 + w^2): Gauss's rule of five on panels over which the integrand's
/// singularities, pi/2 beside the line, are as far as the panel is long.
double inverse_square(const Span& u, const Span& v, double w) {
    constexpr std::array<double, 5> places = {0.0, 0.5384693101056831, -0.5384693101056831, 0.9061798459386640,
                                              -0.9061798459386640};
    constexpr std::array<double, 5> weights = {0.5688888888888889, 0.4786286704993665, 0.4786286704993665,
                                               0.2369268850561891, 0.2369268850561891};
    constexpr double longest = 1.5;
    const double from = std::asinh(u.low / w), length = std::asinh(u.high / w) - from;
    const int panels = std::max(1, static_cast<int>(std::ceil(length / longest)));
    const double half = 0.5 * length / panels;
    double sum = 0.0;
    for (int panel = 0; panel < panels; ++panel) {
        const double middle = from + (2.0 * panel + 1.0) * half;
        for (std::size_t k = 0; k < places.size(); ++k) {
            sum += weights[k] * angle_of(v, w * std::cosh(middle + half * places[k]));
        }
    }
    return half * sum;
}

/// The rectangle in coordinates along its sides with the receiver above their origin.
class SeenRectangle {
public:
    SeenRectangle(const PatchFrame& frame, const Receiver& receiver) {
        deviation_u_ = glm::length(frame.along);
        deviation_v_ = glm::length(frame.across);
        const Vec3 along = frame.along / deviation_u_, across = frame.across / deviation_v_;
        const Vec3 front = glm::cross(along, across);
        const Vec3 seen = frame.centre - receiver.position;
        centre_u_ = glm::dot(seen, along);
        centre_v_ = glm::dot(seen, across);
        w_ = -glm::dot(seen, front);
        const double half_u = std::numbers::sqrt3 * deviation_u_, half_v = std::numbers::sqrt3 * deviation_v_;
        u_ = {centre_u_ - half_u, centre_u_ + half_u};
        v_ = {centre_v_ - half_v, centre_v_ + half_v};
        n_u_ = glm::dot(receiver.normal, along);
        n_v_ = glm::dot(receiver.normal, across);
        n_w_ = -glm::dot(receiver.normal, front);  // towards the rectangle's plane

        b_u_low_ = distance(u_.low);
        b_u_high_ = distance(u_.high);
        b_v_low_ = distance(v_.low);
        b_v_high_ = distance(v_.high);
        g_low_ = angle_of(v_, b_u_low_) / b_u_low_;
        g_high_ = angle_of(v_, b_u_high_) / b_u_high_;
        h_low_ = angle_of(u_, b_v_low_) / b_v_low_;
        h_high_ = angle_of(u_, b_v_high_) / b_v_high_;
    }

    /// pi times the form factor.
    double factor() const { return n_u_ * w_ * first_u() + n_v_ * w_ * first_v() + n_w_ * plain(); }

    KernelMiddle middle() const {
        const double all = factor();
        double square = 0.0;
        if (std::abs(n_u_) + std::abs(n_v_) > 1e-12) {  // else the rectangle lies level before the receiver
            const bool u_is_shorter = u_.length() < v_.length();
            square = u_is_shorter ? inverse_square(u_, v_, w_) : inverse_square(v_, u_, w_);
        }
        const double uu = 0.5 * (square - sides_u()), vv = 0.5 * (square - sides_v()), uv = second_uv();
        const double moment_u = w_ * (n_u_ * uu + n_v_ * uv + n_w_ * w_ * first_u());
        const double moment_v = w_ * (n_u_ * uv + n_v_ * vv + n_w_ * w_ * first_v());
        const double moment_uv = w_ * (n_u_ * third_uuv() + n_v_ * third_uvv() + n_w_ * w_ * uv);

        KernelMiddle seen;
        seen.factor = std::clamp(all / std::numbers::pi, 0.0, 1.0);
        if (!(all > 0.0)) return seen;
        const double mean_u = moment_u / all - centre_u_, mean_v = moment_v / all - centre_v_;
        const double mean_uv = moment_uv / all - centre_u_ * mean_v - centre_v_ * mean_u - centre_u_ * centre_v_;
        seen.middle = {mean_u / deviation_u_, mean_v / deviation_v_};
        seen.product = mean_uv / (deviation_u_ * deviation_v_);
        return seen;
    }

private:
    double distance(double side) const { return std::sqrt(side * side + w_ * w_); }
    double sides_u() const { return u_.high * g_high_ - u_.low * g_low_; }
    double sides_v() const { return v_.high * h_high_ - v_.low * h_low_; }
    /// Integrals over r^4 of w^2, u, v, u v, u^2 v and u v^2.
    double plain() const { return 0.5 * (sides_u() + sides_v()); }
    double first_u() const { return 0.5 * (g_low_ - g_high_); }
    double first_v() const { return 0.5 * (h_low_ - h_high_); }
    double second_uv() const {
        const auto square = [&](double u, double v) { return u * u + v * v + w_ * w_; };
        const double same = square(u_.low, v_.low) * square(u_.high, v_.high);
        const double other = square(u_.low, v_.high) * square(u_.high, v_.low);
        return 0.25 * std::log(other / same);
    }
    double third_uuv() const { return 0.5 * (b_v_high_ * b_v_high_ * h_high_ - b_v_low_ * b_v_low_ * h_low_); }
    double third_uvv() const { return 0.5 * (b_u_high_ * b_u_high_ * g_high_ - b_u_low_ * b_u_low_ * g_low_); }

    double deviation_u_ = 0.0, deviation_v_ = 0.0, centre_u_ = 0.0, centre_v_ = 0.0;
    Span u_{}, v_{};
    double w_ = 0.0, n_u_ = 0.0, n_v_ = 0.0, n_w_ = 0.0;
    double b_u_low_ = 0.0, b_u_high_ = 0.0, b_v_low_ = 0.0, b_v_high_ = 0.0;  ///< distances of the sides' lines
    double g_low_ = 0.0, g_high_ = 0.0, h_low_ = 0.0, h_high_ = 0.0;          ///< angle over distance of each side
};

}  // namespace

double rectangle_factor(const PatchFrame& frame, const Receiver& receiver) {
    return std::clamp(SeenRectangle(frame, receiver).factor() / std::numbers::pi, 0.0, 1.0);
}

KernelMiddle rectangle_middle(const PatchFrame& frame, const Receiver& receiver) {
    return SeenRectangle(frame, receiver).middle();
}

}  // namespace hanei
