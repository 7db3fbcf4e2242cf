#include "ui/view/screen_picture.h"

#include <algorithm>
#include <glad/gl.h>

namespace hanei {

Image picture_of_screen(PixelSize window, int left, int top, PixelSize wished) {
    const int right = std::min(window.width, left + wished.width);
    const int bottom = std::min(window.height, top + wished.height);
    left = std::max(0, left);
    top = std::max(0, top);
    if (right <= left || bottom <= top) return {};
    Image image{right - left, bottom - top, {}};
    const std::size_t row = 4 * static_cast<std::size_t>(image.width);
    std::vector<std::uint8_t> upside_down(row * static_cast<std::size_t>(image.height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(left, window.height - bottom, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                 upside_down.data());
    for (std::size_t k = 3; k < upside_down.size(); k += 4) upside_down[k] = 255;
    image.rgba.resize(upside_down.size());
    for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
        const auto from = upside_down.end() - static_cast<std::ptrdiff_t>((y + 1) * row);
        std::copy(from, from + static_cast<std::ptrdiff_t>(row),
                  image.rgba.begin() + static_cast<std::ptrdiff_t>(y * row));
    }
    return image;
}

}  // namespace hanei
