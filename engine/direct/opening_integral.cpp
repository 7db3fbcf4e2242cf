#include "engine/direct/opening_integral.h"

#include "engine/scene/intensity.h"

#include <algorithm>
#include <cmath>

namespace hanei {

namespace {

constexpr int deepest_level = 10;
constexpr double accuracy = 1e-3;  // of the sum, between the last two levels

bool is_parallelogram(std::span<const Vec3> polygon) {
    if (polygon.size() != 4) return false;
    const Vec3 gap = polygon[0] + polygon[2] - polygon[1] - polygon[3];
    return glm::length(gap) <= 1e-9 * glm::distance(polygon[0], polygon[2]);
}

}  // namespace

OpeningIntegral::OpeningIntegral(const Photometry& photometry, const Mat3& rotation, const Receiver& receiver,
                                 double finest_beam)
    : photometry_(photometry),
      rotation_(rotation),
      receiver_(receiver),
      finest_beam_(std::clamp(finest_beam, 0.1, 1.0)) {}

std::array<OpeningIntegral::Element, 4> OpeningIntegral::Element::quarters() const {
    const Vec3 half_u = 0.5 * u, half_v = 0.5 * v;
    const Element last = triangle ? Element{corner + half_u + half_v, -half_u, -half_v, true}
                                  : Element{corner + half_u + half_v, half_u, half_v, false};
    return {Element{corner, half_u, half_v, triangle}, Element{corner + half_u, half_u, half_v, triangle},
            Element{corner + half_v, half_u, half_v, triangle}, last};
}

double OpeningIntegral::arriving(const Vec3& place) const {
    const Vec3 from_place = receiver_.position - place;
    const double square = glm::dot(from_place, from_place);
    const double height = -glm::dot(from_place, receiver_.normal);
    if (!(height > 0.0) || !(square > 0.0)) return 0.0;
    const double distance = std::sqrt(square);
    const Vec3 local = (from_place / distance) * rotation_;  // a row times a rotation: its inverse
    return intensity(photometry_, local).value * height / (square * distance);
}

double OpeningIntegral::sum(const Element& element) const {
    const double area = glm::length(glm::cross(element.u, element.v));
    const auto at = [&](double a, double b) { return arriving(element.corner + a * element.u + b * element.v); };
    if (element.triangle) {
        return area / 6.0 * (at(1.0 / 6.0, 1.0 / 6.0) + at(2.0 / 3.0, 1.0 / 6.0) + at(1.0 / 6.0, 2.0 / 3.0));
    }
    constexpr double near = 0.21132486540518713, far = 1.0 - near;  // (1 -+ 1/sqrt 3) / 2
    return 0.25 * area * (at(near, near) + at(far, near) + at(near, far) + at(far, far));
}

bool OpeningIntegral::is_fine(const Element& element) const {
    const double size = std::max(glm::length(element.u + element.v), glm::length(element.u - element.v));
    const Vec3 middle = element.corner + (element.triangle ? 1.0 / 3.0 : 0.5) * (element.u + element.v);
    return size <= finest_beam_ * glm::distance(middle, receiver_.position);
}

void OpeningIntegral::add(std::span<const Vec3> polygon) {
    if (polygon.size() < 3) return;
    if (is_parallelogram(polygon)) {
        add_element({polygon[0], polygon[1] - polygon[0], polygon[3] - polygon[0], false}, deepest_level);
        return;
    }
    for (std::size_t k = 2; k < polygon.size(); ++k) {
        add_element({polygon[0], polygon[k - 1] - polygon[0], polygon[k] - polygon[0], true}, deepest_level);
    }
}

void OpeningIntegral::add_element(Element element, int levels) {
    if (levels == 0 || is_fine(element)) {
        element.value = sum(element);
        elements_.push_back(element);
        return;
    }
    for (const Element& quarter : element.quarters()) add_element(quarter, levels - 1);
}

double OpeningIntegral::refined(const Element& element, double tolerance, int levels) const {
    std::array<Element, 4> quarters = element.quarters();
    double total = 0.0;
    for (Element& quarter : quarters) total += quarter.value = sum(quarter);
    if (levels == 0 || std::abs(total - element.value) <= tolerance) return total;
    total = 0.0;
    for (const Element& quarter : quarters) total += refined(quarter, 0.5 * tolerance, levels - 1);
    return total;
}

double OpeningIntegral::value() const {
    double coarse = 0.0;
    for (const Element& element : elements_) coarse += element.value;
    const double share = accuracy * coarse / std::sqrt(static_cast<double>(std::max<std::size_t>(1, elements_.size())));
    double total = 0.0;
    for (const Element& element : elements_) total += refined(element, share, deepest_level);
    return total;
}

}  // namespace hanei
