/// A framebuffer of its own to draw pictures into. Private to the room.
#pragma once

#include "ui/view/image.h"
#include "ui/view/picture_size.h"

#include <glad/gl.h>

namespace hanei {

/// Four samples a pixel where the driver has them. While it lives it is bound; afterwards the
/// framebuffer from before is.
class Frame {
public:
    explicit Frame(PixelSize size);  ///< throws std::runtime_error when the driver has no room for it
    ~Frame();
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;

    Image read();  ///< opaque, rows from the top

private:
    PixelSize size_;
    GLint bound_before_ = 0;
    GLuint sampled_ = 0, plain_ = 0;
    GLuint buffers_[3] = {};  ///< colour, depth, resolved colour
};

}  // namespace hanei
