#include "ui/view/pixel_tiles.h"

#include <algorithm>

namespace hanei {

std::vector<std::size_t> PixelTiles::pixels(std::size_t tile) const {
    const int left = side * static_cast<int>(tile % static_cast<std::size_t>(columns_));
    const int top = side * static_cast<int>(tile / static_cast<std::size_t>(columns_));
    const int right = std::min(left + side, size_.width), bottom = std::min(top + side, size_.height);
    std::vector<std::size_t> pixels;
    pixels.reserve(static_cast<std::size_t>(side * side));
    for (int v = top; v < bottom; v += block) {
        for (int u = left; u < right; u += block) {
            for (int y = v; y < std::min(v + block, bottom); ++y) {
                for (int x = u; x < std::min(u + block, right); ++x)
                    pixels.push_back(static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
                                     static_cast<std::size_t>(x));
            }
        }
    }
    return pixels;
}

}  // namespace hanei
