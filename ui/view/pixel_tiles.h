/// A picture cut into squares of pixels whose borders depend on its size alone.
#pragma once

#include "ui/view/picture_size.h"

#include <cstddef>
#include <vector>

namespace hanei {

class PixelTiles {
public:
    explicit PixelTiles(PixelSize size) : size_(size), columns_(up(size.width)), rows_(up(size.height)) {}

    std::size_t count() const { return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_); }

    /// Numbers of a tile's pixels (row by row in the picture), block after block of 8 x 8: what lies
    /// side by side in the picture follows one another.
    std::vector<std::size_t> pixels(std::size_t tile) const;

private:
    static constexpr int side = 32, block = 8;
    static int up(int pixels) { return (pixels + side - 1) / side; }

    PixelSize size_;
    int columns_, rows_;
};

}  // namespace hanei
