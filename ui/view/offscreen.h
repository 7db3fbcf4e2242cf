/// OpenGL without a display: EGL surfaceless, else OSMesa (opened at run time).
#pragma once

#include "ui/view/exact_picture.h"
#include "ui/view/image.h"
#include "ui/view/length_unit.h"
#include "ui/view/renderer.h"

#include <memory>
#include <string>

namespace hanei {

class OffscreenContext {
public:
    /// Makes a context and makes it current on this thread. Throws std::runtime_error with both
    /// reasons when neither way works.
    OffscreenContext();
    ~OffscreenContext();
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    const std::string& description() const;  ///< "EGL surfaceless, llvmpipe ..."

    struct Handles;

private:
    std::unique_ptr<Handles> handles_;
};

/// A picture of a solution as the window would show it, with 4 samples a pixel.
/// `annotated`: legend with quantity and unit, isolux labels, and a caption under the picture.
struct PictureRequest {
    Camera camera;
    ViewOptions options;
    PixelSize size{1280, 800};
    bool annotated = true;
    std::string caption;  ///< empty: title, part, settings and error of the solution
    /// The room in this camera and with these options, of view_size; null: as the window shows it.
    std::shared_ptr<const ExactPicture> exact = nullptr;
    bool has_legend = true, has_caption = true;  ///< of an annotated picture
    bool has_scale_bar = true;                   ///< of one that is annotated and to scale
    bool has_axes = false;
    LengthUnit length = LengthUnit::metre;  ///< of the scale bar
};

/// Part of the picture that shows the room; the rest is legend and caption. Fit cameras to its
/// aspect.
PixelSize view_size(const PictureRequest& request);

/// Exactly request.size, whatever is annotated.
/// Needs     a current context (offscreen or window); the framebuffer that is bound stays bound.
Image render_picture(SolutionSnapshot solution, const PictureRequest& request);

/// Total, direct, unshadowed and interreflected side by side, one scale (the paper's Fig. 4e).
/// A part that the solution does not hold is said to be missing, never drawn as zero.
Image render_four_up(SolutionSnapshot solution, const PictureRequest& request);

}  // namespace hanei
