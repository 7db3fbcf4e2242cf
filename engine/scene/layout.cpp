#include "engine/scene/layout.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei {
namespace {

struct Places {
    std::vector<LayoutPlace> made;

    void operator()(const LineLayout& line) {
        for (int k = 0; k < line.count; ++k) {
            const double share = line.count == 1 ? 0.5 : static_cast<double>(k) / (line.count - 1);
            made.push_back({glm::mix(line.from, line.to, share), 0.0});
        }
    }
    void operator()(const FieldLayout& field) {
        for (int row = 0; row < field.rows; ++row) {
            const Vec3 start = field.corner + (row + 0.5) / field.rows * field.across;
            for (int column = 0; column < field.columns; ++column)
                made.push_back({start + (column + 0.5) / field.columns * field.along, 0.0});
        }
    }
    void operator()(const CircleLayout& circle) {
        for (int k = 0; k < circle.count; ++k) {
            const double angle = circle.first_angle + 2.0 * std::numbers::pi * k / circle.count;
            const Vec3 out{std::cos(angle), std::sin(angle), 0.0};
            made.push_back({circle.middle + circle.radius * out, circle.face_outward ? angle : 0.0});
        }
    }
};

struct Count {
    static std::size_t at_least_none(int count) { return static_cast<std::size_t>(std::max(0, count)); }
    std::size_t operator()(const LineLayout& line) const { return at_least_none(line.count); }
    std::size_t operator()(const FieldLayout& field) const {
        return at_least_none(field.rows) * at_least_none(field.columns);
    }
    std::size_t operator()(const CircleLayout& circle) const { return at_least_none(circle.count); }
};

}  // namespace

std::vector<LayoutPlace> places_of(const Layout& layout) {
    Places places;
    places.made.reserve(place_count(layout));
    std::visit(places, layout);
    return std::move(places.made);
}

std::size_t place_count(const Layout& layout) { return std::visit(Count{}, layout); }

}  // namespace hanei
