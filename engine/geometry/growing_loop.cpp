#include "engine/geometry/growing_loop.h"

namespace hanei {

GrowingLoop::GrowingLoop(const Triangle& first) {
    for (std::size_t k = 0; k < 3; ++k) next_[first.corner[k]] = first.corner[(k + 1) % 3];
}

bool GrowingLoop::runs(int from, int to) const {
    const auto found = next_.find(from);
    return found != next_.end() && found->second == to;
}

bool GrowingLoop::add(const Triangle& triangle) {
    std::array<bool, 3> shared{};
    int count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        shared[k] = runs(triangle.corner[(k + 1) % 3], triangle.corner[k]);
        count += shared[k] ? 1 : 0;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const int a = triangle.corner[k], b = triangle.corner[(k + 1) % 3], c = triangle.corner[(k + 2) % 3];
        if (count == 1 && shared[k]) {
            if (next_.count(c) > 0) return false;
            next_[b] = c;
            next_[c] = a;
            return true;
        }
        if (count == 2 && shared[k] && shared[(k + 1) % 3] && size() > 3) {  // c to b to a becomes c to a
            next_.erase(b);
            next_[c] = a;
            return true;
        }
    }
    return false;
}

std::vector<int> GrowingLoop::corners() const {
    std::vector<int> list;
    int at = next_.begin()->first;
    do {
        list.push_back(at);
        at = next_.at(at);
    } while (at != list.front());
    return list;
}

}  // namespace hanei
