#include "ui/view/frame.h"

#include <algorithm>
#include <stdexcept>

namespace hanei {

Frame::Frame(PixelSize size) : size_(size) {
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &bound_before_);
    GLint samples = 0, greatest = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &samples);
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &greatest);
    if (size.width < 1 || size.height < 1 || size.width > greatest || size.height > greatest) {
        throw std::runtime_error("The picture has more pixels than the graphics driver can draw");
    }
    samples = std::min(4, samples);
    glGenFramebuffers(1, &plain_);
    glGenFramebuffers(1, &sampled_);
    glGenRenderbuffers(3, buffers_);
    glBindRenderbuffer(GL_RENDERBUFFER, buffers_[2]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size.width, size.height);
    glBindFramebuffer(GL_FRAMEBUFFER, plain_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers_[2]);
    glBindRenderbuffer(GL_RENDERBUFFER, buffers_[0]);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, size.width, size.height);
    glBindRenderbuffer(GL_RENDERBUFFER, buffers_[1]);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, size.width, size.height);
    glBindFramebuffer(GL_FRAMEBUFFER, sampled_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers_[0]);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, buffers_[1]);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw std::runtime_error("The graphics driver has no room for a picture of this size");
    }
}

Frame::~Frame() {
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound_before_));
    glDeleteFramebuffers(1, &sampled_);
    glDeleteFramebuffers(1, &plain_);
    glDeleteRenderbuffers(3, buffers_);
}

Image Frame::read() {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, sampled_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, plain_);
    glBlitFramebuffer(0, 0, size_.width, size_.height, 0, 0, size_.width, size_.height, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, plain_);
    Image image{size_.width, size_.height, {}};
    const std::size_t row = 4 * static_cast<std::size_t>(size_.width);
    image.rgba.resize(row * static_cast<std::size_t>(size_.height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size_.width, size_.height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    glBindFramebuffer(GL_FRAMEBUFFER, sampled_);
    for (int y = 0; y < size_.height / 2; ++y) {  // OpenGL's rows run from the bottom
        const auto top = image.rgba.begin() + static_cast<std::ptrdiff_t>(row) * y;
        const auto bottom = image.rgba.begin() + static_cast<std::ptrdiff_t>(row) * (size_.height - 1 - y);
        std::swap_ranges(top, top + static_cast<std::ptrdiff_t>(row), bottom);
    }
    for (std::size_t k = 3; k < image.rgba.size(); k += 4) image.rgba[k] = 255;
    return image;
}

}  // namespace hanei
