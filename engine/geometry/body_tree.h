/// A bounding volume hierarchy over boxes.
#pragma once

#include "engine/geometry/body_shape.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hanei {

/// Holds     box numbers only: the boxes' owner keeps the bodies.
/// Cost      about 1 us a box to build; a visit touches a few nodes a level.
class BodyTree {
public:
    BodyTree() = default;
    explicit BodyTree(std::span<const Box> boxes);

    /// Calls `found(number)` for every box that `may_touch(box)` lets through, and whose enclosing
    /// boxes it lets through, in no particular order.
    template <class MayTouch, class Found>
    void visit(MayTouch&& may_touch, Found&& found) const {
        if (nodes_.empty()) return;
        std::array<std::uint32_t, 64> stack;  // halving: never deeper than the bits of a box number
        std::size_t depth = 0;
        stack[depth++] = 0;
        while (depth > 0) {
            const Node& node = nodes_[stack[--depth]];
            if (!may_touch(node.box)) continue;
            if (node.count == 0) {
                stack[depth++] = node.first;
                stack[depth++] = node.first + 1;
                continue;
            }
            for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
                if (node.count == 1 || may_touch(leaves_[k].box)) found(leaves_[k].number);
            }
        }
    }

private:
    struct Node {
        Box box;
        std::uint32_t first = 0;  ///< left child, or first leaf
        std::uint32_t count = 0;  ///< leaves; 0 for an inner node
    };
    struct Leaf {
        Box box;
        std::uint32_t number = 0;
    };
    void split(std::uint32_t node, std::uint32_t first, std::uint32_t count);

    std::vector<Node> nodes_;
    std::vector<Leaf> leaves_;
};

}  // namespace hanei
