/// The 3D pictures of the window. Panels know no OpenGL: whoever runs them paints these.
#pragma once

#include "ui/view/renderer.h"

#include <functional>

namespace hanei {

struct ViewRequest {
    int slot = 0;  ///< which picture of the window: 0, or 0 to 3 when four are shown
    SceneSnapshot scene;
    SolutionSnapshot solution;  ///< may be null, or of an older scene
    Camera camera;
    ViewOptions options;
    Highlights highlights;
    PixelSize size;
    bool moving = false;  ///< the user is dragging: fast before smooth

    /// A finished picture in place of all the above, in a slot of its own.
    static constexpr int picture_slot = 4;
    const Image* picture = nullptr;
    long picture_number = 0;  ///< another picture has another number
};

/// Returns a texture as ImGui knows it, valid until the next call for the same slot; null paints nothing.
using ViewPainter = std::function<void*(const ViewRequest&)>;

}  // namespace hanei
