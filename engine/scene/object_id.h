#pragma once

#include <compare>
#include <cstdint>

namespace hanei {

/// Names one authored object of a scene. 0 names nothing.
struct ObjectId {
    std::uint32_t value = 0;
    auto operator<=>(const ObjectId&) const = default;
    explicit operator bool() const { return value != 0; }
};

}  // namespace hanei
