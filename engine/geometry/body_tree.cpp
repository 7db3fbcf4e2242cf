#include "engine/geometry/body_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hanei {

namespace {

constexpr float farthest = std::numeric_limits<float>::max();

float rounded_down(double value) {
    if (!(value > -static_cast<double>(farthest))) return -farthest;
    if (value >= static_cast<double>(farthest)) return farthest;
    const auto near = static_cast<float>(value);
    return static_cast<double>(near) > value ? std::nextafter(near, -farthest) : near;
}

float rounded_up(double value) { return -rounded_down(-value); }

double area(const Box& box) {
    const Vec3 size = box.high - box.low;
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

template <class Leaf>
Box around(std::span<const Leaf> leaves) {
    Box box = leaves[0].box;
    for (const Leaf& leaf : leaves) box.include(leaf.box);
    return box;
}

/// Boxes counted by the place of their centres along an axis.
struct Slot {
    Box box;
    std::size_t count = 0;
    void include(const Box& other) {
        if (count == 0) {
            box = other;
        } else {
            box.include(other);
        }
    }
};
constexpr int slots = 12;

struct Cut {
    int axis = -1;  ///< -1: none
    double low = 0.0, per_metre = 0.0;
    int last_left = 0;
    double cost = std::numeric_limits<double>::infinity();

    int slot(const Box& box) const {
        return std::clamp(static_cast<int>((box.centre()[axis] - low) * per_metre), 0, slots - 1);
    }
};

/// The cut with the least sum of area times boxes (Wald 2007, binned).
template <class Leaf>
Cut best_cut(std::span<const Leaf> leaves) {
    Box centres{leaves[0].box.centre(), leaves[0].box.centre()};
    for (const Leaf& leaf : leaves) centres.include(leaf.box.centre());
    Cut best;
    for (int axis = 0; axis < 3; ++axis) {
        const double length = centres.high[axis] - centres.low[axis];
        Cut cut{axis, centres.low[axis], slots / length, 0, 0.0};
        if (!(length > 0.0) || !std::isfinite(cut.per_metre)) continue;
        std::array<Slot, slots> all;
        for (const Leaf& leaf : leaves) {
            Slot& slot = all[static_cast<std::size_t>(cut.slot(leaf.box))];
            slot.include(leaf.box);
            ++slot.count;
        }
        std::array<double, slots> right{};
        Slot sum;
        for (int k = slots - 1; k > 0; --k) {
            const Slot& slot = all[static_cast<std::size_t>(k)];
            if (slot.count > 0) sum.include(slot.box);
            sum.count += slot.count;
            right[static_cast<std::size_t>(k)] = sum.count > 0 ? area(sum.box) * static_cast<double>(sum.count) : 0.0;
        }
        sum = {};
        for (int k = 0; k + 1 < slots; ++k) {
            const Slot& slot = all[static_cast<std::size_t>(k)];
            if (slot.count > 0) sum.include(slot.box);
            sum.count += slot.count;
            if (sum.count == 0 || sum.count == leaves.size()) continue;
            cut.cost = area(sum.box) * static_cast<double>(sum.count) + right[static_cast<std::size_t>(k + 1)];
            cut.last_left = k;
            if (cut.cost < best.cost) best = cut;
        }
    }
    return best;
}

/// Halves by number where no cut parts the centres, or to keep the tree from growing deep.
template <class Leaf>
std::size_t part(std::span<Leaf> leaves, bool in_halves) {
    const Cut cut = in_halves ? Cut{} : best_cut(std::span<const Leaf>(leaves));
    if (cut.axis < 0) return leaves.size() / 2;
    const auto middle = std::partition(leaves.begin(), leaves.end(),
                                       [&](const Leaf& leaf) { return cut.slot(leaf.box) <= cut.last_left; });
    return static_cast<std::size_t>(middle - leaves.begin());
}

}  // namespace

BodyTree::BodyTree(std::span<const Box> boxes) {
    if (boxes.empty()) return;
    std::vector<Leaf> leaves;
    leaves.reserve(boxes.size());
    for (std::size_t k = 0; k < boxes.size(); ++k) leaves.push_back({boxes[k], static_cast<std::uint32_t>(k)});
    const Box all = around(std::span<const Leaf>(leaves));
    const Vec3 half = all.half_size();
    centre_ = all.centre();
    reach_ = std::max({half.x, half.y, half.z});
    nodes_.reserve(boxes.size() / 2 + 1);
    build(leaves, 0);
}

std::uint32_t BodyTree::build(std::span<Leaf> leaves, int depth) {
    constexpr int deepest_by_area = 24;  // below, halves: 32 levels more hold any number of boxes
    std::array<std::span<Leaf>, 4> parts{leaves};
    std::array<double, 4> areas{area(around(std::span<const Leaf>(leaves)))};
    std::size_t count = 1;
    while (count < parts.size()) {
        std::size_t widest = count;
        for (std::size_t k = 0; k < count; ++k) {
            if (parts[k].size() > 1 && (widest == count || areas[k] > areas[widest])) widest = k;
        }
        if (widest == count) break;
        const std::span<Leaf> whole = parts[widest];
        const std::size_t left = part(whole, depth >= deepest_by_area);
        parts[widest] = whole.first(left);
        parts[count] = whole.subspan(left);
        for (const std::size_t k : {widest, count}) areas[k] = area(around(std::span<const Leaf>(parts[k])));
        ++count;
    }
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    Node& fresh = nodes_.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) fresh.bounds[k] = all_four(farthest), fresh.bounds[k + 3] = all_four(-farthest);
    fresh.child.fill(is_box);
    for (std::size_t k = 0; k < count; ++k) {
        const Box box = around(std::span<const Leaf>(parts[k]));
        const std::uint32_t child = parts[k].size() == 1 ? parts[k][0].number | is_box : build(parts[k], depth + 1);
        set_child(nodes_[number], k, box, child);
    }
    return number;
}

void BodyTree::set_child(Node& node, std::size_t slot, const Box& box, std::uint32_t child) const {
    for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        node.bounds[k][slot] = rounded_down(box.low[axis] - centre_[axis]);
        node.bounds[k + 3][slot] = rounded_up(box.high[axis] - centre_[axis]);
    }
    node.child[slot] = child;
}

void BodyTree::Gauge::Side::set(const Vec3& direction, double to) {
    x = all_four(static_cast<float>(direction.x));
    y = all_four(static_cast<float>(direction.y));
    z = all_four(static_cast<float>(direction.z));
    at_x = direction.x >= 0.0 ? 0 : 3;
    at_y = direction.y >= 0.0 ? 1 : 4;
    at_z = direction.z >= 0.0 ? 2 : 5;
    reach = all_four(static_cast<float>(to));
}

BodyTree::Gauge::Gauge(const Enclosure& region, const Vec3& centre, double reach) {
    // Differences and products in single precision err by less than these shares.
    constexpr double of_coordinates = 1e-6, of_reach = 2.5e-7;
    for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        low_[k] = all_four(rounded_down(region.bounds.low[axis] - centre[axis]));
        high_[k] = all_four(rounded_up(region.bounds.high[axis] - centre[axis]));
    }
    for (const Enclosure::Side& side : region.planes()) {
        double size = std::abs(side.outward.x) + std::abs(side.outward.y) + std::abs(side.outward.z);
        const double scale = size > 1e-20 && size < 1e20 ? 1.0 : 1.0 / size;  // the rest leaves single precision
        size *= scale;
        const Vec3 outward = scale * side.outward;
        const double to = scale * side.reach + glm::dot(outward, region.origin - centre);
        sides_[count_++].set(outward, to + of_reach * std::abs(to) + of_coordinates * reach * size);
    }
    forward_.set(region.forward, 0.0);
}

}  // namespace hanei
