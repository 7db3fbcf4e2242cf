/// A bounding volume hierarchy over boxes.
#pragma once

#include "engine/geometry/enclosure.h"
#include "engine/geometry/four.h"

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace hanei {

/// Four boxes a node, held against an enclosure at once. Boxes are kept in single precision, rounded
/// outward, and planes are moved outward by the rounding of the test: none that reaches in is missed.
///
/// Holds     box numbers only: the boxes' owner keeps the bodies.
/// Cost      about 1 us a box to build; a visit touches a few nodes a level.
class BodyTree {
public:
    BodyTree() = default;
    explicit BodyTree(std::span<const Box> boxes);

    /// Calls `found(number)` for every box that may reach into the region, the nearer along its
    /// `forward` sooner by and large, until `found` returns false.
    template <class Found>
    void visit(const Enclosure& region, Found&& found) const {
        if (nodes_.empty()) return;
        const Gauge gauge(region, centre_, reach_);
        std::array<std::uint32_t, 256> waiting;  // three more a level, under 64 levels (see build)
        std::size_t count = 0;
        waiting[count++] = 0;
        while (count > 0) {
            const std::uint32_t next = waiting[--count];
            if (next & is_box) {
                if (!found(next & ~is_box)) return;
                continue;
            }
            const Node& node = nodes_[next];
            const int reached = gauge.reached(node);
            if (reached != 0) count = push_farthest_first(node, reached, gauge.distances(node), waiting.data(), count);
        }
    }

private:
    static constexpr std::uint32_t is_box = 1U << 31U;

    struct Node {
        std::array<Four, 6> bounds;          ///< low x, y, z, high x, y, z of the children's boxes
        std::array<std::uint32_t, 4> child;  ///< a node, or is_box and the number of a box
    };

    /// An enclosure in the tree's own numbers.
    class Gauge {
    public:
        Gauge(const Enclosure& region, const Vec3& centre, double reach);

        /// Children that may reach into the region, a bit each.
        int reached(const Node& node) const {
            FourFlags out = (node.bounds[0] > high_[0]) | (node.bounds[1] > high_[1]) | (node.bounds[2] > high_[2]) |
                            (node.bounds[3] < low_[0]) | (node.bounds[4] < low_[1]) | (node.bounds[5] < low_[2]);
            for (std::size_t k = 0; k < count_; ++k) out |= sides_[k].least(node) > sides_[k].reach;
            return bits_of(out) ^ 15;
        }
        Four distances(const Node& node) const { return forward_.least(node); }

    private:
        struct Side {
            Four x, y, z, reach;
            std::uint32_t at_x, at_y, at_z;  ///< the bounds at which the side's direction is least

            void set(const Vec3& direction, double to);
            Four least(const Node& node) const {
                return x * node.bounds[at_x] + y * node.bounds[at_y] + z * node.bounds[at_z];
            }
        };
        std::array<Four, 3> low_, high_;
        Side forward_;
        std::size_t count_ = 0;
        std::array<Side, std::tuple_size_v<decltype(Enclosure::sides)>> sides_;
    };

    struct Leaf {
        Box box;
        std::uint32_t number = 0;
    };
    struct Range {
        std::uint32_t first = 0, count = 0;
    };

    static std::size_t push_farthest_first(const Node& node, int reached, Four distances, std::uint32_t* waiting,
                                           std::size_t count) {
        const std::size_t first = count;
        std::array<float, 4> pushed;
        for (auto bits = static_cast<unsigned>(reached); bits != 0; bits &= bits - 1) {
            const int slot = std::countr_zero(bits);
            std::size_t at = count++;
            for (; at > first && pushed[at - 1 - first] < distances[slot]; --at) {
                pushed[at - first] = pushed[at - 1 - first];
                waiting[at] = waiting[at - 1];
            }
            pushed[at - first] = distances[slot];
            waiting[at] = node.child[static_cast<std::size_t>(slot)];
        }
        return count;
    }
    std::uint32_t build(std::span<Leaf> leaves, int depth);
    void set_child(Node& node, std::size_t slot, const Box& box, std::uint32_t child) const;

    std::vector<Node> nodes_;
    Vec3 centre_{0.0};    ///< origin of the boxes' own numbers
    double reach_ = 0.0;  ///< no coordinate of a box is greater
};

}  // namespace hanei
