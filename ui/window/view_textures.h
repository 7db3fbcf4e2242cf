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
    Renderer renderer_;
    SceneSnapshot scene_;
    SolutionSnapshot solution_;
    std::array<std::unique_ptr<Slot>, 4> slots_;
    long painted_ = 0;
};

}  // namespace hanei
