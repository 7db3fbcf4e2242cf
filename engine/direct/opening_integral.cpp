#include "engine/direct/opening_integral.h"

#include <algorithm>
#include <cmath>

namespace hanei {

namespace {

constexpr int deepest_level = 10;
constexpr double accuracy = 2e-3;  // sum of all differences between the last two levels, of the result

// Sizes of elements over the distance in which the distribution changes by its peak: the greatest
// that cannot miss a beam, and one so small that four Gauss points leave less than 1e-4.
constexpr double first_share = 1.5;
constexpr double settled_share = 0.2;

bool is_parallelogram(std::span<const Vec3> polygon) {
    if (polygon.size() != 4) return false;
    const Vec3 gap = polygon[0] + polygon[2] - polygon[1] - polygon[3];
    return glm::length(gap) <= 1e-9 * glm::distance(polygon[0], polygon[2]);
}

}  // namespace

OpeningIntegral::OpeningIntegral(const IntensityTable& table, const Mat3& rotation, const Receiver& receiver,
                                 double finest_beam)
    : table_(table), rotation_(rotation), receiver_(receiver), finest_beam_(std::clamp(finest_beam, 0.1, 1.0)) {}

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
    const Vec3 local = from_place * rotation_;  // a row times a rotation: its inverse
    return table_.candela(local) * height / (square * distance);
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

bool OpeningIntegral::is_finer(const Element& element, double share) const {
    const double size = std::max(glm::length(element.u + element.v), glm::length(element.u - element.v));
    const Vec3 middle = element.corner + (element.triangle ? 1.0 / 3.0 : 0.5) * (element.u + element.v);
    return size <= share * finest_beam_ * glm::distance(middle, receiver_.position);
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
    if (levels == 0 || is_finer(element, first_share)) {
        element.value = sum(element);
        elements_.push_back(element);
        return;
    }
    for (const Element& quarter : element.quarters()) add_element(quarter, levels - 1);
}

OpeningIntegral::Halved OpeningIntegral::halved(const Element& element, int levels) const {
    Halved result{element.quarters(), 0.0, 0.0, levels};
    for (Element& quarter : result.quarters) result.sum += quarter.value = sum(quarter);
    result.difference = std::abs(result.sum - element.value);
    return result;
}

double OpeningIntegral::value() const {
    thread_local std::vector<Halved> open;  // a heap, the greatest difference on top
    const auto less = [](const Halved& a, const Halved& b) { return a.difference < b.difference; };
    open.clear();
    double settled = 0.0, total = 0.0, differences = 0.0;
    for (const Element& element : elements_) {
        if (is_finer(element, settled_share)) {
            settled += element.value;
        } else {
            open.push_back(halved(element, deepest_level));
            total += open.back().sum;
            differences += open.back().difference;
        }
    }
    std::ranges::make_heap(open, less);
    while (differences > accuracy * (settled + total) && open.front().levels > 0) {
        std::ranges::pop_heap(open, less);
        const Halved coarse = open.back();
        open.pop_back();
        total -= coarse.sum;
        differences -= coarse.difference;
        for (const Element& quarter : coarse.quarters) {
            const Halved finer = halved(quarter, coarse.levels - 1);
            total += finer.sum;
            differences += finer.difference;
            open.push_back(finer);
            std::ranges::push_heap(open, less);
        }
    }
    double sum_of_all = settled;  // added anew: taking away and adding rounds
    for (const Halved& part : open) sum_of_all += part.sum;
    return sum_of_all;
}

}  // namespace hanei
