#include "engine/transport/kernel_middle.h"

#include "engine/geometry/polygon.h"

#include <algorithm>
#include <cmath>

namespace hanei {

namespace {

/// A part whose corners are within this share of its distance is far: what four points of the kernel
/// leave out of its middle goes with the cube of it.
constexpr double far_reach = 0.15;
/// Parts of 1/256 of the polygon are small enough wherever they lie.
constexpr int deepest = 8;

double kernel(const Vec3& seen, const Vec3& normal, const Vec3& front) {
    const double square = glm::dot(seen, seen);
    if (square <= 0.0) return 0.0;
    return std::max(0.0, glm::dot(seen, normal)) * std::max(0.0, -glm::dot(seen, front)) / (square * square);
}

class MiddleOfParts {
public:
    MiddleOfParts(const Receiver& receiver, const PatchFrame& whole)
        : receiver_(receiver), whole_(whole), front_(glm::normalize(glm::cross(whole.along, whole.across))) {}

    /// Needs     a part above the horizon, with its frame and its form factor.
    void add(const Polygon& part, const PatchFrame& frame, double factor, int depth) {
        if (factor <= 0.0) return;
        double reach = 0.0;
        for (const Vec3& corner : part) reach = std::max(reach, glm::length(corner - frame.centre));
        if (reach <= far_reach * glm::length(frame.centre - receiver_.position)) {
            add_far(frame, factor);
        } else if (depth == deepest) {
            add_at(frame.centre, factor);
        } else {
            for (const Polygon& quarter : quarters_of(part, frame)) {
                if (unit_normal(quarter) == Vec3{0.0}) continue;
                const PatchFrame around = frame_of(quarter, front_, frame.along);
                add(quarter, around, configuration_factor(quarter, receiver_), depth + 1);
            }
        }
    }

    /// Means over all light of the parts; where none has any, what arrives `otherwise` comes from there.
    void write_middle(KernelMiddle& seen, const Vec3& otherwise) {
        if (!(light_ > 0.0)) add_at(otherwise, 1.0);
        seen.middle = moment_ / light_;
        seen.product = product_ / light_;
    }

private:
    void add_at(const Vec3& place, double light) {
        const Vec2 at = whole_.coordinates(place);
        light_ += light;
        moment_ += light * at;
        product_ += light * at.x * at.y;
    }

    /// The light shared out by the kernel at the four nodes.
    void add_far(const PatchFrame& frame, double light) {
        std::array<double, 4> values{};
        double sum = 0.0;
        for (unsigned k = 0; k < 4; ++k) {
            values[k] = kernel(frame.node(k) - receiver_.position, receiver_.normal, front_);
            sum += values[k];
        }
        if (!(sum > 0.0)) return add_at(frame.centre, light);
        for (unsigned k = 0; k < 4; ++k) add_at(frame.node(k), light * values[k] / sum);
    }

    const Receiver& receiver_;
    const PatchFrame& whole_;
    Vec3 front_;
    Vec2 moment_{0.0};
    double light_ = 0.0, product_ = 0.0;
};

}  // namespace

KernelMiddle kernel_middle(const Polygon& polygon, const PatchFrame& frame, const Receiver& receiver) {
    KernelMiddle seen;
    seen.factor = configuration_factor(polygon, receiver);
    if (seen.factor <= 0.0) return seen;
    MiddleOfParts parts(receiver, frame);
    if (is_above_horizon(polygon, receiver)) {
        parts.add(polygon, frame, seen.factor, 0);
    } else {
        const Polygon visible = clipped(polygon, {receiver.position, receiver.normal}, 0.0);
        const Vec3 front = unit_normal(visible);
        if (front != Vec3{0.0}) parts.add(visible, frame_of(visible, front, frame.along), seen.factor, 0);
    }
    // a receiver in the polygon's plane: all its light comes from where it touches
    parts.write_middle(seen, receiver.position);
    return seen;
}

bool is_above_horizon(const Polygon& polygon, const Receiver& receiver) {
    return std::all_of(polygon.begin(), polygon.end(), [&](const Vec3& corner) {
        return glm::dot(corner - receiver.position, receiver.normal) >= 0.0;
    });
}

std::array<double, 4> node_shares(const KernelMiddle& seen) {
    const double xi = std::clamp(seen.middle.x, -1.0, 1.0), eta = std::clamp(seen.middle.y, -1.0, 1.0);
    const double product = std::clamp(seen.product, std::abs(xi + eta) - 1.0, 1.0 - std::abs(xi - eta));
    const double share = 0.25 * seen.factor;
    const auto at_least_0 = [&](double value) { return share * std::max(0.0, value); };
    return {at_least_0(1.0 - xi - eta + product), at_least_0(1.0 + xi - eta - product),
            at_least_0(1.0 - xi + eta - product), at_least_0(1.0 + xi + eta + product)};
}

}  // namespace hanei
