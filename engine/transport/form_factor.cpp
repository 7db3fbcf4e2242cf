#include "engine/base/tolerance.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/visible_part.h"
#include "engine/mesh/pieces.h"
#include "engine/transport/contour_pair.h"
#include "engine/transport/factors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

namespace hanei {

namespace {

struct RulePoint {
    double weight, a, b;  ///< weights add up to 1; the third coordinate is 1 - a - b
};
// Degree 5 on the triangle (Radon 1948).
constexpr std::array<RulePoint, 7> degree_5 = {{{0.225, 1.0 / 3.0, 1.0 / 3.0},
                                                {0.13239415278850618, 0.47014206410511509, 0.47014206410511509},
                                                {0.13239415278850618, 0.47014206410511509, 0.05971587178976982},
                                                {0.13239415278850618, 0.05971587178976982, 0.47014206410511509},
                                                {0.12593918054482715, 0.10128650732345634, 0.10128650732345634},
                                                {0.12593918054482715, 0.10128650732345634, 0.79742698535308732},
                                                {0.12593918054482715, 0.79742698535308732, 0.10128650732345634}}};

/// Integral over triangles, the worst of them quartered until little is left to doubt.
template <class Value>
class AdaptiveIntegral {
public:
    explicit AdaptiveIntegral(const Value& value) : value_(value) {}

    void add(const Vec3& a, const Vec3& b, const Vec3& c) { push({{a, b, c}, rule(a, b, c), 0.0, {}, next_++}); }

    double total(double relative_accuracy, int most_triangles) {
        while (next_ < most_triangles && !queue_.empty() && doubt_ > relative_accuracy * std::abs(sum_)) {
            const Triangle worst = queue_.top();
            queue_.pop();
            sum_ -= worst.fine();
            doubt_ -= worst.doubt;
            for (const auto& [corners, value] : worst.quarters) push({corners, value, 0.0, {}, next_++});
        }
        double exact = 0.0;  // the running sums carry the rounding of all they once held
        for (; !queue_.empty(); queue_.pop()) exact += queue_.top().fine();
        return exact;
    }

private:
    struct Quarter {
        std::array<Vec3, 3> corners;
        double value = 0.0;
    };
    struct Triangle {
        std::array<Vec3, 3> corners;
        double coarse = 0.0;
        double doubt = 0.0;
        std::array<Quarter, 4> quarters;
        int number = 0;  ///< breaks ties, so that the order is always the same

        double fine() const { return quarters[0].value + quarters[1].value + quarters[2].value + quarters[3].value; }
        bool operator<(const Triangle& other) const {
            return doubt != other.doubt ? doubt < other.doubt : number > other.number;
        }
    };

    double rule(const Vec3& a, const Vec3& b, const Vec3& c) const {
        double sum = 0.0;
        for (const RulePoint& point : degree_5) {
            sum += point.weight * value_(point.a * a + point.b * b + (1.0 - point.a - point.b) * c);
        }
        return sum * 0.5 * glm::length(glm::cross(b - a, c - a));
    }

    void push(Triangle triangle) {
        const auto& [a, b, c] = triangle.corners;
        const Vec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
        triangle.quarters = {{{{a, ab, ca}, rule(a, ab, ca)},
                              {{ab, b, bc}, rule(ab, b, bc)},
                              {{ca, bc, c}, rule(ca, bc, c)},
                              {{ab, bc, ca}, rule(ab, bc, ca)}}};
        triangle.doubt = std::abs(triangle.fine() - triangle.coarse);
        sum_ += triangle.fine();
        doubt_ += triangle.doubt;
        queue_.push(triangle);
    }

    const Value& value_;
    std::priority_queue<Triangle> queue_;
    double sum_ = 0.0;
    double doubt_ = 0.0;
    int next_ = 0;
};

/// Bodies that may stand between two polygons: not behind either, and within their common bounds.
std::vector<BodyIndex> bodies_between(const Polygon& from, const Polygon& to, const OccluderSet& occluders) {
    Box box{from.front(), from.front()};
    for (const Polygon* polygon : {&from, &to}) {
        for (const Vec3& corner : *polygon) box.include(corner);
    }
    const Plane planes[] = {{from.front(), unit_normal(from)}, {to.front(), unit_normal(to)}};
    const double same_place = occluders.same_place();
    std::vector<BodyIndex> found;
    for (BodyIndex body = 0; body < occluders.bodies().size(); ++body) {
        const Box& around = occluders.shape(body).box;
        const Vec3 beyond = glm::max(around.low - box.high, box.low - around.high);
        if (std::max({beyond.x, beyond.y, beyond.z}) > same_place) continue;
        const bool behind = std::any_of(std::begin(planes), std::end(planes), [&](const Plane& plane) {
            const auto& vertices = occluders.bodies()[body].vertices;
            return std::all_of(vertices.begin(), vertices.end(),
                               [&](const Vec3& v) { return plane.height(v) <= same_place; });
        });
        if (!behind) found.push_back(body);
    }
    return found;
}

Polygon in_front(const Polygon& polygon, const Polygon& of) {
    const double thickness = tolerance::same_place * (diameter(polygon) + diameter(of));
    return clipped(polygon, {of.front(), unit_normal(of)}, thickness);
}

/// Area of `from` times its form factor to `to`, past bodies.
double exchange(const Polygon& from, const Polygon& to, const OccluderSet& occluders) {
    const Polygon a = in_front(from, to);
    const Polygon b = in_front(to, from);
    if (a.empty() || b.empty()) return 0.0;
    const std::vector<BodyIndex> bodies = bodies_between(a, b, occluders);
    // Far away the contours' terms cancel, and a few points integrate exactly.
    const bool far = glm::length(centroid(a) - centroid(b)) > 4.0 * (diameter(a) + diameter(b));
    if (bodies.empty() && !far) return contour_exchange(a, b);

    const Vec3 normal = unit_normal(from);
    const auto factor_at = [&](const Vec3& place) {
        return visible_configuration_factor(b, {place, normal, Vec3(0.0)}, occluders, bodies);
    };
    AdaptiveIntegral integral(factor_at);
    for (std::size_t k = 2; k < a.size(); ++k) integral.add(a[0], a[k - 1], a[k]);
    return integral.total(1e-7, 20'000);
}

}  // namespace

double form_factor(const Region& from, const Region& to, const OccluderSet& occluders) {
    const double area = glm::length(vector_area(from));
    if (!(area > 0.0)) return 0.0;
    const std::vector<Polygon> senders = pieces_of(from, unit_normal(from.outline));
    const std::vector<Polygon> receivers = pieces_of(to, unit_normal(to.outline));
    double sum = 0.0;
    for (const Polygon& a : senders) {
        for (const Polygon& b : receivers) sum += exchange(a, b, occluders);
    }
    return std::clamp(sum / area, 0.0, 1.0);
}

}  // namespace hanei
