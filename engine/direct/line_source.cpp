#include "engine/direct/line_source.h"

#include <algorithm>
#include <cmath>

namespace hanei {

namespace {

/// x - sin x for 0 <= x <= 2 pi without cancellation.
double angle_minus_sine(double x) {
    if (x > 0.6) return x - std::sin(x);
    const double s = x * x;  // the first term left out is below 1e-17 of the first
    return x * s / 6.0 * (1.0 - s / 20.0 * (1.0 - s / 42.0 * (1.0 - s / 72.0 * (1.0 - s / 110.0 * (1.0 - s / 156.0)))));
}

}  // namespace

double LineSource::unobstructed(const Receiver& receiver, double first, double last) const {
    const Vec3 whole = to - from;
    const double length = glm::length(whole);
    if (!(length > 0.0)) return 0.0;
    const Vec3 along = whole / length;
    Vec3 a = from - receiver.position + first * whole;
    const Vec3 far_end = a + (last - first) * whole;
    double span = (last - first) * length;
    const double height_a = glm::dot(a, receiver.normal);
    const double height_b = glm::dot(far_end, receiver.normal);
    if (height_a <= 0.0 && height_b <= 0.0) return 0.0;
    if (height_a < 0.0) {
        a += (height_a / (height_a - height_b)) * (last - first) * whole;
        span *= height_b / (height_b - height_a);
    }
    if (height_b < 0.0) span *= height_a / (height_a - height_b);
    const Vec3 b = a + span * along;

    const Vec3 foot = glm::cross(along, glm::cross(a, along));
    const double h = glm::length(foot);
    if (!(h > 1e-14 * (glm::length(a) + glm::length(b)))) return 0.0;
    const double start = glm::dot(a, along);
    const double end = start + span;
    const double squares = glm::dot(a, a) * glm::dot(b, b);
    const double twice_angle = 2.0 * std::atan2(h * span, h * h + start * end);
    const double across = angle_minus_sine(twice_angle) / (4.0 * h * h * h) + span / squares;
    const double lengthwise = span * (start + end) / (2.0 * squares);
    const double sum = glm::dot(foot, receiver.normal) * across + glm::dot(along, receiver.normal) * lengthwise;
    return std::max(0.0, normal_intensity * h * sum);
}

double LineSource::from_place(const Vec3& place, const Receiver& receiver) const {
    const Vec3 away = receiver.position - place;
    const double square = glm::dot(away, away), height = -glm::dot(away, receiver.normal);
    if (!(height > 0.0) || !(square > 0.0)) return 0.0;
    return normal_intensity * glm::length(glm::cross(to - from, away)) * height / (square * square);
}

}  // namespace hanei
