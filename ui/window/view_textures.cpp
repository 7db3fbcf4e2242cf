#include "ui/window/view_textures.h"

#include <algorithm>
#include <cstdint>
#include <glad/gl.h>

namespace hanei {
namespace {

constexpr int samples_at_rest = 4;

bool same_marks(const Highlights& a, const Highlights& b) {
    return a.selected == b.selected && a.hovered == b.hovered && a.lines.empty() && b.lines.empty();
}

}  // namespace

/// A framebuffer to draw into, with samples, and the texture it is resolved to.
struct ViewTextures::Slot {
    ViewRequest shown;
    PixelSize size;
    int samples = -1;
    GLuint texture = 0;
    GLuint resolved = 0;  ///< framebuffer around the texture
    GLuint drawn = 0;     ///< framebuffer drawn into
    GLuint buffers[2] = {};

    ~Slot() { release(); }

    void release() {
        glDeleteFramebuffers(1, &resolved);
        glDeleteFramebuffers(1, &drawn);
        glDeleteRenderbuffers(2, buffers);
        glDeleteTextures(1, &texture);
    }

    void make(PixelSize wished, int wished_samples) {
        if (wished == size && wished_samples == samples) return;
        release();
        size = wished;
        samples = wished_samples;
        glGenTextures(1, &texture);
        glBindTexture(GL_TEXTURE_2D, texture);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glGenFramebuffers(1, &resolved);
        glBindFramebuffer(GL_FRAMEBUFFER, resolved);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
        glGenFramebuffers(1, &drawn);
        glGenRenderbuffers(2, buffers);
        glBindFramebuffer(GL_FRAMEBUFFER, drawn);
        const GLenum formats[] = {GL_RGBA8, GL_DEPTH_COMPONENT24};
        const GLenum attachments[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
        for (int k = 0; k < 2; ++k) {
            glBindRenderbuffer(GL_RENDERBUFFER, buffers[k]);
            glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, formats[k], size.width, size.height);
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachments[k], GL_RENDERBUFFER, buffers[k]);
        }
    }

    bool shows(const ViewRequest& request, int wished_samples) const {
        return samples == wished_samples && size == request.size && shown.scene == request.scene &&
               shown.solution == request.solution && shown.camera == request.camera &&
               shown.options == request.options && same_marks(shown.highlights, request.highlights);
    }
};

ViewTextures::ViewTextures() = default;
ViewTextures::~ViewTextures() { glDeleteTextures(1, &picture_); }

void* ViewTextures::finished(const Image& picture, long number) {
    if (picture_ == 0) glGenTextures(1, &picture_);
    if (picture_number_ != number) {
        picture_number_ = number;
        glBindTexture(GL_TEXTURE_2D, picture_);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture.width, picture.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     picture.rgba.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glBindTexture(GL_TEXTURE_2D, 0);
        ++painted_;
    }
    return reinterpret_cast<void*>(static_cast<std::uintptr_t>(picture_));
}

void* ViewTextures::paint(const ViewRequest& request) {
    if (request.picture != nullptr) return finished(*request.picture, request.picture_number);
    std::unique_ptr<Slot>& slot = slots_[static_cast<std::size_t>(std::clamp(request.slot, 0, 3))];
    if (!slot) slot = std::make_unique<Slot>();
    const int samples = request.moving ? 0 : samples_at_rest;
    void* const shown = reinterpret_cast<void*>(static_cast<std::uintptr_t>(slot->texture));
    if (request.size.width <= 0 || request.size.height <= 0) return nullptr;
    if (slot->texture != 0 && slot->shows(request, samples)) return shown;

    GLint before = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &before);
    slot->make(request.size, samples);
    if (scene_ != request.scene) renderer_.set_scene(scene_ = request.scene);
    if (solution_ != request.solution) renderer_.set_solution(solution_ = request.solution);
    glBindFramebuffer(GL_FRAMEBUFFER, slot->drawn);
    renderer_.draw(request.camera, request.options, request.highlights, request.size);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, slot->drawn);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, slot->resolved);
    glBlitFramebuffer(0, 0, request.size.width, request.size.height, 0, 0, request.size.width, request.size.height,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(before));
    slot->shown = request;
    ++painted_;
    return reinterpret_cast<void*>(static_cast<std::uintptr_t>(slot->texture));
}

}  // namespace hanei
