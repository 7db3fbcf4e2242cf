#include "engine/geometry/body_tree.h"

#include <algorithm>

namespace hanei {

namespace {

constexpr std::uint32_t leaf_size = 2;

int longest_axis(const Vec3& size) {
    if (size.x >= size.y && size.x >= size.z) return 0;
    return size.y >= size.z ? 1 : 2;
}

}  // namespace

BodyTree::BodyTree(std::span<const Box> boxes) {
    if (boxes.empty()) return;
    leaves_.reserve(boxes.size());
    for (std::size_t k = 0; k < boxes.size(); ++k) leaves_.push_back({boxes[k], static_cast<std::uint32_t>(k)});
    nodes_.reserve(2 * boxes.size());
    nodes_.emplace_back();
    split(0, 0, static_cast<std::uint32_t>(boxes.size()));
}

void BodyTree::split(std::uint32_t node, std::uint32_t first, std::uint32_t count) {
    Box box = leaves_[first].box;
    Box centres{box.centre(), box.centre()};
    for (std::uint32_t k = first; k < first + count; ++k) {
        box.include(leaves_[k].box);
        centres.include(leaves_[k].box.centre());
    }
    nodes_[node].box = box;
    if (count <= leaf_size) {
        nodes_[node].first = first;
        nodes_[node].count = count;
        return;
    }
    const int axis = longest_axis(centres.high - centres.low);
    const auto begin = leaves_.begin() + first;
    const std::uint32_t half = count / 2;
    std::nth_element(begin, begin + half, begin + count, [axis](const Leaf& a, const Leaf& b) {
        const double at_a = a.box.centre()[axis], at_b = b.box.centre()[axis];
        return at_a != at_b ? at_a < at_b : a.number < b.number;
    });
    const auto left = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].first = left;
    nodes_.emplace_back();
    nodes_.emplace_back();
    split(left, first, half);
    split(left + 1, first + half, count - half);
}

}  // namespace hanei
