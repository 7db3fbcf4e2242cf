#include "ui/view/ray_tree.h"

#include <numeric>

namespace hanei {
namespace {

constexpr std::uint32_t leaf_size = 2;

int longest_axis(const Vec3& size) {
    if (size.x >= size.y && size.x >= size.z) return 0;
    return size.y >= size.z ? 1 : 2;
}

}  // namespace

RayTree::RayTree(std::span<const Box> boxes) {
    if (boxes.empty()) return;
    numbers_.resize(boxes.size());
    std::iota(numbers_.begin(), numbers_.end(), 0U);
    nodes_.reserve(2 * boxes.size());
    nodes_.emplace_back();
    split(boxes, 0, 0, static_cast<std::uint32_t>(boxes.size()));
}

void RayTree::split(std::span<const Box> boxes, std::uint32_t node, std::uint32_t first, std::uint32_t count) {
    Box box = boxes[numbers_[first]];
    Box centres{box.centre(), box.centre()};
    for (std::uint32_t k = first; k < first + count; ++k) {
        box.include(boxes[numbers_[k]]);
        centres.include(boxes[numbers_[k]].centre());
    }
    nodes_[node].box = box;
    if (count <= leaf_size) {
        nodes_[node].first = first;
        nodes_[node].count = count;
        return;
    }
    const int axis = longest_axis(centres.high - centres.low);
    const auto begin = numbers_.begin() + first;
    const std::uint32_t half = count / 2;
    std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
        const double at_a = boxes[a].centre()[axis], at_b = boxes[b].centre()[axis];
        return at_a != at_b ? at_a < at_b : a < b;
    });
    const auto lower = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].first = lower;
    nodes_[node].axis = axis;
    nodes_.emplace_back();
    nodes_.emplace_back();
    split(boxes, lower, first, half);
    split(boxes, lower + 1, first + half, count - half);
}

}  // namespace hanei
