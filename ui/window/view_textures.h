/// The 3D pictures of the window as textures, painted again only when something in them changed.
#pragma once

#include "ui/panels/view_painter.h"

#include <array>
#include <memory>

namespace hanei {

/// Needs     a current OpenGL 3.3 context, the same for its whole life.
class ViewTextures {
public:
    ViewTextures();
    ~ViewTextures();

    /// Four samples a pixel at rest, one while the user is moving something.
    void* paint(const ViewRequest& request);

    long painted() const { return painted_; }  ///< pictures painted so far

private:
    struct Slot;
    void* finished(const Image& picture, long number);
    Renderer renderer_;
    SceneSnapshot scene_;
    SolutionSnapshot solution_;
    std::array<std::unique_ptr<Slot>, 4> slots_;
    unsigned picture_ = 0;  ///< texture of a finished picture
    long picture_number_ = -1;
    long painted_ = 0;
};

}  // namespace hanei
