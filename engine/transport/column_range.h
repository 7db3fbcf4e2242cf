/// Some neighbouring columns of a matrix.
#pragma once

#include <cstddef>

namespace hanei {

struct ColumnRange {
    std::size_t first = 0, last = 0;  ///< one past the end
    bool operator==(const ColumnRange&) const = default;
};

}  // namespace hanei
