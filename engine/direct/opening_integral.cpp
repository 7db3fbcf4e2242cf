#include "engine/direct/opening_integral.h"

#include "engine/direct/flat_cell.h"
#include "engine/geometry/polygon.h"

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
constexpr double settled_share = 0.1;

constexpr double narrow = 4.0;                   // so much longer than wide, only the length matters
constexpr double of_side = 0.28867513459481287;  // 1 / sqrt 12: Gauss points from the middle

bool is_parallelogram(std::span<const Vec3> polygon) {
    if (polygon.size() != 4) return false;
    const Vec3 gap = polygon[0] + polygon[2] - polygon[1] - polygon[3];
    return glm::length(gap) <= 1e-9 * glm::distance(polygon[0], polygon[2]);
}

}  // namespace

OpeningIntegral::OpeningIntegral(const IntensityTable& table, const OpeningSolid* solid, const Receiver& receiver,
                                 double finest_beam)
    : table_(table), solid_(solid), receiver_(receiver), finest_beam_(std::clamp(finest_beam, 0.1, 1.0)) {}

/// The rectangle about a polygon, along its longest edge.
OpeningIntegral::Element OpeningIntegral::around(const Polygon& polygon) {
    const Vec3 normal = unit_normal(polygon);
    Vec3 longest{0.0};
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3 edge = polygon[(k + 1) % polygon.size()] - polygon[k];
        if (glm::dot(edge, edge) > glm::dot(longest, longest)) longest = edge;
    }
    if (normal == Vec3{0.0} || longest == Vec3{0.0}) return {};
    const Vec3 x = glm::normalize(longest), y = glm::cross(normal, x);
    Vec2 low{0.0}, high{0.0};
    for (const Vec3& corner : polygon) {
        const Vec3 away = corner - polygon[0];
        const Vec2 at{glm::dot(away, x), glm::dot(away, y)};
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    return {polygon[0] + low.x * x + low.y * y, (high.x - low.x) * x, (high.y - low.y) * y, polygon};
}

std::array<OpeningIntegral::Element, 4> OpeningIntegral::Element::quarters() const {
    const double aspect = glm::length(u) / glm::length(v);
    const bool first_u = aspect >= 1.0, then_u = first_u ? aspect >= narrow : aspect >= 1.0 / narrow;
    auto [first, second] = halves(first_u);
    auto [a, b] = first.halves(then_u);
    auto [c, d] = second.halves(then_u);
    return {std::move(a), std::move(b), std::move(c), std::move(d)};
}

/// Two parts, of half of u or of v.
std::array<OpeningIntegral::Element, 2> OpeningIntegral::Element::halves(bool cut_u) const {
    const Vec3 half = 0.5 * (cut_u ? u : v), &other = cut_u ? v : u;
    std::array<Element, 2> parts{Element{corner, cut_u ? half : u, cut_u ? v : half, {}},
                                 Element{corner + half, cut_u ? half : u, cut_u ? v : half, {}}};
    if (outline.empty()) return parts;
    const double length = glm::length(half), whole = length * glm::length(other);
    for (Element& part : parts) {
        const bool first = &part == parts.data();
        part.outline =
            length > 0.0 ? clipped(outline, {corner + half, (first ? -half : half) / length}, 0.0) : Polygon{};
        if (part.outline.size() < 3) {
            part = Element{corner + half, Vec3{0.0}, Vec3{0.0}, {}};
        } else if (part.outline.size() == 4 && glm::length(vector_area(part.outline)) >= (1.0 - 1e-9) * whole) {
            part.outline.clear();
        }
    }
    return parts;
}

/// Fills in what the element sends to the receiver. Lane by lane: the places are all alike, and the
/// compiler does two or four at a time.
void OpeningIntegral::measure(Element& element) const {
    Vec3 vector_area = glm::cross(element.u, element.v);
    if (vector_area == Vec3{0.0}) return;
    Vec3 from_middle = receiver_.position - element.corner - 0.5 * (element.u + element.v);
    Vec3 along = of_side * element.u, across = of_side * element.v;
    if (!element.outline.empty()) {
        const FlatCell cell(element.outline);
        if (cell.count == 0) return;
        from_middle = receiver_.position - cell.centre;
        along = cell.along;
        across = cell.across;
        vector_area *= cell.size / glm::length(vector_area);
    }
    constexpr double signs[2][4] = {{1.0, -1.0, 1.0, -1.0}, {1.0, 1.0, -1.0, -1.0}};
    double x[4], y[4], z[4], clear[4];
    for (std::size_t k = 0; k < 4; ++k) {
        x[k] = from_middle.x + signs[0][k] * along.x + signs[1][k] * across.x;
        y[k] = from_middle.y + signs[0][k] * along.y + signs[1][k] * across.y;
        z[k] = from_middle.z + signs[0][k] * along.z + signs[1][k] * across.z;
        const double square = x[k] * x[k] + y[k] * y[k] + z[k] * z[k];
        const double height = -(x[k] * receiver_.normal.x + y[k] * receiver_.normal.y + z[k] * receiver_.normal.z);
        clear[k] = std::max(0.0, height) / std::max(square * std::sqrt(square), 1e-300);
    }
    double light = 0.0, geometry = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
        if (!(clear[k] > 0.0)) continue;
        const Vec3 away{x[k], y[k], z[k]};
        if (solid_) clear[k] *= weight(away, vector_area);
        light += clear[k] * table_.candela(away);
        geometry += clear[k];
    }
    const double share = 0.25 * (solid_ ? 1.0 : glm::length(vector_area));
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
    const Vec3 middle = element.corner + 0.5 * (element.u + element.v);
    return size <= share * finest_beam_ * glm::distance(middle, receiver_.position);
}

void OpeningIntegral::add(const Polygon& polygon) {
    if (polygon.size() < 3) return;
    const bool whole = is_parallelogram(polygon);
    add_element(whole ? Element{polygon[0], polygon[1] - polygon[0], polygon[3] - polygon[0], {}} : around(polygon),
                deepest_level);
}

void OpeningIntegral::add_element(Element element, int levels) {
    if (levels == 0 || is_finer(element, first_share)) {
        measure(element);
        elements_.push_back(std::move(element));
        return;
    }
    for (Element& quarter : element.quarters()) add_element(std::move(quarter), levels - 1);
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
        const Halved coarse = std::move(open.back());
        open.pop_back();
        total -= coarse.sum;
        left.remove(coarse.difference);
        for (const Element& quarter : coarse.quarters) {
            Halved finer = halved(quarter, coarse.levels - 1);
            total += finer.sum;
            left.add(finer.difference);
            open.push_back(std::move(finer));
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
