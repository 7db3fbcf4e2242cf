/// Shapes the geometry tests are made of.
#pragma once

#include "engine/geometry/occluders.h"

#include <random>

namespace hanei::testing {

inline ConvexBody box_body(const Vec3& low, const Vec3& high) {
    ConvexBody body;
    for (int k = 0; k < 8; ++k) {
        body.vertices.emplace_back(k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z);
    }
    body.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    return body;
}

inline ConvexBody sheet(const Polygon& outline) {
    ConvexBody body;
    body.vertices = outline;
    body.faces.emplace_back();
    for (std::size_t k = 0; k < outline.size(); ++k) body.faces[0].push_back(static_cast<int>(k));
    return body;
}

/// A rectangle at height z that faces down (seen from below it runs counter-clockwise).
inline Polygon facing_down(double x0, double y0, double x1, double y1, double z) {
    return {{x0, y0, z}, {x0, y1, z}, {x1, y1, z}, {x1, y0, z}};
}
inline Polygon facing_up(double x0, double y0, double x1, double y1, double z) {
    return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

/// Numbers that are the same on every machine (std distributions are not).
class Dice {
public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    Vec3 place(double reach) { return {uniform(-reach, reach), uniform(-reach, reach), uniform(-reach, reach)}; }
    Vec3 direction() {
        for (;;) {
            const Vec3 v = place(1.0);
            const double length = glm::length(v);
            if (length > 0.1 && length < 1.0) return v / length;
        }
    }
    Mat3 rotation() {
        const Vec3 x = direction();
        const Vec3 y = glm::normalize(glm::cross(direction(), x));
        return {x, y, glm::cross(x, y)};
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace hanei::testing
