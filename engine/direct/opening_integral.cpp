#include "engine/direct/opening_integral.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hanei {

namespace {

constexpr int deepest_level = 10;
constexpr double finest_accuracy = 4e-3;   // of the result, at which cutting ends
constexpr double faintest = 2e-5;          // of the peak: what is less is not looked into
constexpr double error_of_settled = 8e-4;  // of elements that are not cut

/// Differences between elements and their quarters. Where the table is smooth the quarters err by a
/// fifteenth of them, all the same way; where it is bent, by up to as much, either way.
class Differences {
public:
    void add(double difference) {
        sum_ += difference;
        squares_ += difference * difference;
    }
    void remove(double difference) {
        sum_ -= difference;
        squares_ -= difference * difference;
    }
    double error() const { return 0.1 * sum_ + 2.0 * std::sqrt(std::max(0.0, squares_)); }

private:
    double sum_ = 0.0, squares_ = 0.0;
};

// Sizes of elements over the distance in which the distribution changes by its peak: the greatest
// that cannot miss a beam, and one so small that four Gauss points leave less than 1e-4.
constexpr double first_share = 1.5;
constexpr double settled_share = 0.2;

// Gauss points of the unit square and of the triangle under its diagonal (one lane idle).
using Points = std::pair<std::array<double, 4>, std::array<double, 4>>;
constexpr double near = 0.21132486540518713, far = 1.0 - near;  // (1 -+ 1/sqrt 3) / 2
constexpr Points square_points = {{near, far, near, far}, {near, near, far, far}};
constexpr Points triangle_points = {{1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0, 1.0 / 3.0},
                                    {1.0 / 6.0, 1.0 / 6.0, 2.0 / 3.0, 1.0 / 3.0}};

bool is_parallelogram(std::span<const Vec3> polygon) {
    if (polygon.size() != 4) return false;
    const Vec3 gap = polygon[0] + polygon[2] - polygon[1] - polygon[3];
    return glm::length(gap) <= 1e-9 * glm::distance(polygon[0], polygon[2]);
}

}  // namespace

OpeningIntegral::OpeningIntegral(const IntensityTable& table, const OpeningSolid* solid, const Receiver& receiver,
                                 double finest_beam)
    : table_(table), solid_(solid), receiver_(receiver), finest_beam_(std::clamp(finest_beam, 0.1, 1.0)) {}

std::array<OpeningIntegral::Element, 4> OpeningIntegral::Element::quarters() const {
    const Vec3 half_u = 0.5 * u, half_v = 0.5 * v;
    const Element last = triangle ? Element{corner + half_u + half_v, -half_u, -half_v, true}
                                  : Element{corner + half_u + half_v, half_u, half_v, false};
    return {Element{corner, half_u, half_v, triangle}, Element{corner + half_u, half_u, half_v, triangle},
            Element{corner + half_v, half_u, half_v, triangle}, last};
}

/// Fills in what the element sends to the receiver. Lane by lane: the places are all alike, and the
/// compiler does two or four at a time.
void OpeningIntegral::measure(Element& element) const {
    const Vec3 vector_area = glm::cross(element.u, element.v);
    const std::size_t count = element.triangle ? 3 : 4;
    const auto& along = element.triangle ? triangle_points.first : square_points.first;
    const auto& across = element.triangle ? triangle_points.second : square_points.second;
    const Vec3 from_corner = receiver_.position - element.corner;
    double x[4], y[4], z[4], clear[4];
    for (std::size_t k = 0; k < 4; ++k) {
        x[k] = from_corner.x - along[k] * element.u.x - across[k] * element.v.x;
        y[k] = from_corner.y - along[k] * element.u.y - across[k] * element.v.y;
        z[k] = from_corner.z - along[k] * element.u.z - across[k] * element.v.z;
        const double square = x[k] * x[k] + y[k] * y[k] + z[k] * z[k];
        const double height = -(x[k] * receiver_.normal.x + y[k] * receiver_.normal.y + z[k] * receiver_.normal.z);
        clear[k] = std::max(0.0, height) / std::max(square * std::sqrt(square), 1e-300);
    }
    double light = 0.0, geometry = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
        if (!(clear[k] > 0.0)) continue;
        const Vec3 away{x[k], y[k], z[k]};
        if (solid_) clear[k] *= weight(away, vector_area);
        light += clear[k] * table_.candela(away);
        geometry += clear[k];
    }
    const double area = solid_ ? 1.0 : glm::length(vector_area);
    const double share = area / (element.triangle ? 6.0 : 4.0);
    element.value = share * light;
    element.clear = share * geometry;
}

/// Share of a face's element in the projected area towards the receiver.
double OpeningIntegral::weight(const Vec3& away, const Vec3& vector_area) const {
    const double projected = std::abs(glm::dot(vector_area, away));
    if (!(projected > 0.0)) return 0.0;
    const double distance = glm::length(away);
    return projected / (distance * solid_->projected_area(away / distance));
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
        measure(element);
        elements_.push_back(element);
        return;
    }
    for (const Element& quarter : element.quarters()) add_element(quarter, levels - 1);
}

OpeningIntegral::Halved OpeningIntegral::halved(const Element& element, int levels) const {
    Halved result{element.quarters(), 0.0, 0.0, levels};
    for (Element& quarter : result.quarters) {
        measure(quarter);
        result.sum += quarter.value;
    }
    result.difference = std::abs(result.sum - element.value);
    return result;
}

Estimate OpeningIntegral::value(const Accuracy& accuracy) const {
    const double share = std::max(accuracy.share, finest_accuracy);
    thread_local std::vector<Halved> open;  // a heap, the greatest difference on top
    const auto less = [](const Halved& a, const Halved& b) { return a.difference < b.difference; };
    open.clear();
    double settled = 0.0, total = 0.0, clear = 0.0;
    Differences left;
    for (const Element& element : elements_) {
        clear += element.clear;
        if (is_finer(element, settled_share)) {
            settled += element.value;
        } else {
            open.push_back(halved(element, deepest_level));
            total += open.back().sum;
            left.add(open.back().difference);
        }
    }
    std::ranges::make_heap(open, less);
    const double faint = faintest * table_.peak() * clear;
    const double unimportant = std::max(faint, accuracy.floor);
    while (left.error() > std::max(share * (settled + total), unimportant) && open.front().levels > 0) {
        std::ranges::pop_heap(open, less);
        const Halved coarse = open.back();
        open.pop_back();
        total -= coarse.sum;
        left.remove(coarse.difference);
        for (const Element& quarter : coarse.quarters) {
            const Halved finer = halved(quarter, coarse.levels - 1);
            total += finer.sum;
            left.add(finer.difference);
            open.push_back(finer);
            std::ranges::push_heap(open, less);
        }
    }
    Estimate sum{settled, error_of_settled * settled + faint};  // added anew: taking away and adding rounds
    left = {};
    for (const Halved& part : open) {
        sum.value += part.sum;
        left.add(part.difference);
    }
    sum.error += left.error();
    return sum;
}

}  // namespace hanei
