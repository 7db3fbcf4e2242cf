/// Boxes under a bounding volume hierarchy, asked by rays.
#pragma once

#include "engine/geometry/body_shape.h"
#include "ui/view/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace hanei {

/// Holds     box numbers only: whoever made it keeps what lies in the boxes.
/// Cost      about 1 us a box to build; a ray touches a few nodes a level.
class RayTree {
public:
    RayTree() = default;
    explicit RayTree(std::span<const Box> boxes);

    /// Calls `meet(number)`, the nearer sooner by and large, for every box that the ray enters from
    /// `nearest` on and before `farthest`, both in lengths of its direction; `meet` may lower `farthest`.
    template <class Meet>
    void visit(const Ray& ray, double nearest, const double& farthest, Meet&& meet) const {
        if (nodes_.empty()) return;
        const Vec3 inverse(reciprocal(ray.direction.x), reciprocal(ray.direction.y), reciprocal(ray.direction.z));
        const auto enters = [&](const Box& box) {
            const Vec3 low = (box.low - ray.origin) * inverse, high = (box.high - ray.origin) * inverse;
            const Vec3 first = glm::min(low, high), last = glm::max(low, high);
            return std::max({nearest, first.x, first.y, first.z}) <= std::min({farthest, last.x, last.y, last.z});
        };
        std::array<std::uint32_t, 64> stack;  // halving: never deeper than the bits of a box number
        std::size_t depth = 0;
        stack[depth++] = 0;
        while (depth > 0) {
            const Node& node = nodes_[stack[--depth]];
            if (!enters(node.box)) continue;
            if (node.count == 0) {
                const bool low_first = ray.direction[node.axis] >= 0.0;
                stack[depth++] = low_first ? node.first + 1 : node.first;
                stack[depth++] = low_first ? node.first : node.first + 1;
                continue;
            }
            for (std::uint32_t k = node.first; k < node.first + node.count; ++k) meet(numbers_[k]);
        }
    }

private:
    struct Node {
        Box box;
        std::uint32_t first = 0;  ///< the lower child, or first leaf
        std::uint32_t count = 0;  ///< leaves; 0 for an inner node
        int axis = 0;             ///< along which the children lie
    };

    /// The one that keeps 0 times it finite.
    static double reciprocal(double x) { return 1.0 / (std::abs(x) < 1e-300 ? std::copysign(1e-300, x) : x); }
    void split(std::span<const Box> boxes, std::uint32_t node, std::uint32_t first, std::uint32_t count);

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> numbers_;
};

}  // namespace hanei
