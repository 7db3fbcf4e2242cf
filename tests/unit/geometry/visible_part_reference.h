/// The visible form factor once more, in long double and the plainest way: every face turned to the eye
/// and every silhouette edge gives a half-space, bodies are taken away one after another in the order
/// they come, and nothing is left out, sorted or rounded away.
#pragma once

#include "engine/geometry/configuration_factor.h"
#include "engine/geometry/occluders.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace hanei::testing {

using Long = long double;
using Long3 = glm::vec<3, Long>;
using LongPolygon = std::vector<Long3>;

struct LongHalfSpace {
    Long3 outward;
    Long reach;
};

inline std::vector<LongHalfSpace> long_hidden_region(const ConvexBody& body, const Long3& eye) {
    std::vector<LongHalfSpace> planes;
    Long3 middle{0};
    for (const Vec3& v : body.vertices) middle += Long3(v) / static_cast<Long>(body.vertices.size());
    const auto vertex = [&](int k) { return Long3(body.vertices[static_cast<std::size_t>(k)]) - eye; };
    std::vector<bool> front;
    for (const std::vector<int>& face : body.faces) {
        Long3 normal = glm::cross(vertex(face[1]) - vertex(face[0]), vertex(face[2]) - vertex(face[0]));
        if (glm::dot(normal, middle - eye - vertex(face[0])) > 0) normal = -normal;
        front.push_back(glm::dot(normal, vertex(face[0])) < 0);
        if (front.back()) planes.push_back({normal, glm::dot(normal, vertex(face[0]))});
    }
    for (std::size_t f = 0; f < body.faces.size(); ++f) {
        for (std::size_t k = 0; front[f] && k < body.faces[f].size(); ++k) {
            const int a = body.faces[f][k], b = body.faces[f][(k + 1) % body.faces[f].size()];
            for (std::size_t g = 0; g < body.faces.size(); ++g) {
                const auto& other = body.faces[g];
                const bool shared = std::ranges::count(other, a) > 0 && std::ranges::count(other, b) > 0;
                if (g == f || front[g] || !shared) continue;
                Long3 plane = glm::cross(vertex(a), vertex(b));
                if (glm::dot(plane, middle - eye) > 0) plane = -plane;
                planes.push_back({plane, 0});
            }
        }
    }
    return planes;
}

inline LongPolygon long_clipped(const LongPolygon& polygon, const LongHalfSpace& plane, Long side) {
    LongPolygon kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Long3 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        const Long at_a = side * (glm::dot(plane.outward, a) - plane.reach);
        const Long at_b = side * (glm::dot(plane.outward, b) - plane.reach);
        if (at_a >= 0) kept.push_back(a);
        if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0)) kept.push_back(a + at_a / (at_a - at_b) * (b - a));
    }
    return kept.size() < 3 ? LongPolygon{} : kept;
}

inline Long long_factor(const LongPolygon& polygon, const Long3& normal) {
    Long sum = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Long3 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        const Long3 across = glm::cross(b, a);
        const Long length = glm::length(across);
        if (length > 0) sum += std::atan2(length, glm::dot(a, b)) * glm::dot(across, normal) / length;
    }
    return sum / (2 * std::numbers::pi_v<Long>);
}

inline Long long_visible_factor(const Polygon& polygon, const Receiver& receiver, const OccluderSet& set) {
    const Long3 eye(receiver.position), normal(receiver.normal);
    LongPolygon seen;
    for (const Vec3& corner : polygon) seen.push_back(Long3(corner) - eye);
    if (glm::dot(glm::cross(seen[1] - seen[0], seen[2] - seen[0]), seen[0]) >= 0) return 0;  // seen from behind
    std::vector<LongPolygon> pieces{long_clipped(seen, {normal, 0}, 1)};
    for (const ConvexBody& body : set.bodies()) {
        const std::vector<LongHalfSpace> planes = long_hidden_region(body, eye);
        if (planes.empty()) return 0;  // the eye is inside
        std::vector<LongPolygon> left;
        for (const LongPolygon& piece : pieces) {
            LongPolygon rest = piece;
            std::vector<LongPolygon> outside;
            for (const LongHalfSpace& plane : planes) {
                outside.push_back(long_clipped(rest, plane, 1));
                rest = long_clipped(rest, plane, -1);
                if (rest.empty()) break;
            }
            if (rest.empty()) outside.assign(1, piece);
            for (LongPolygon& part : outside) {
                if (!part.empty()) left.push_back(std::move(part));
            }
        }
        pieces = std::move(left);
    }
    Long sum = 0;
    for (const LongPolygon& piece : pieces) sum += long_factor(piece, normal);
    return sum;
}

}  // namespace hanei::testing
