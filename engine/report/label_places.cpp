#include "engine/report/label_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hanei {
namespace {

double overlap(const LabelPlaces::Box& a, const LabelPlaces::Box& b) {
    const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
    const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
    return width > 0.0 && height > 0.0 ? width * height : 0.0;
}

}  // namespace

void LabelPlaces::avoid(double x, double y, double radius) {
    points_.push_back({x - radius, y - radius, x + radius, y + radius});
}

void LabelPlaces::avoid_line(double x, double y, double to_x, double to_y) {
    constexpr double half_width = 2.0;
    points_.push_back({std::min(x, to_x) - half_width, std::min(y, to_y) - half_width, std::max(x, to_x) + half_width,
                       std::max(y, to_y) + half_width});
}

double LabelPlaces::covered(const Box& box) const {
    constexpr double weight_of_labels = 5.0, weight_of_outside = 20.0;
    double sum = 0.0;
    for (const Box& point : points_) sum += overlap(box, point);
    for (const Box& label : labels_) sum += weight_of_labels * overlap(box, label);
    const double area = (box.right - box.left) * (box.bottom - box.top);
    return sum + weight_of_outside * (area - overlap(box, within_));
}

LabelPlace LabelPlaces::place(double x, double y, double width, double height) {
    constexpr double first = 15.0, step = 9.0, cost_of_distance = 0.6;
    constexpr int rings = 7, directions = 16;
    double least = std::numeric_limits<double>::infinity();
    LabelPlace best;
    Box taken;
    for (int ring = 0; ring < rings; ++ring) {
        const double away = first + ring * step;
        for (int k = 0; k < directions; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / directions;
            const double ax = x + away * std::cos(angle), ay = y + away * std::sin(angle);
            const double left = ax - 0.5 * width * (1.0 - std::cos(angle));
            const double top = ay - 0.5 * height * (1.0 - std::sin(angle));
            const Box box{left, top, left + width, top + height};
            const double cost = covered(box) + cost_of_distance * away;
            if (cost >= least) continue;
            least = cost;
            taken = box;
            best = {left, top, std::clamp(x, left, left + width), std::clamp(y, top, top + height), ring > 1};
        }
    }
    labels_.push_back(taken);
    return best;
}

}  // namespace hanei
