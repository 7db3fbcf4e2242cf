/// Draws a room and its light with OpenGL 3.3 core.
///
/// Cells are interpolated bilinearly in the fragment shader from their four corner values (the
/// paper's equation 6), so that no diagonal shows. Faces are seen from their lit side only: a room
/// looked at from outside opens like a doll's house. Before there is a solution, faces are plain
/// in the colours of their materials. Photos show luminance (reflectance x illuminance / pi, band by
/// band) through a shoulder, exposed for the room's mean; calculation points are left out of them.
#pragma once

#include "engine/solution/solution.h"
#include "ui/view/camera.h"
#include "ui/view/image.h"
#include "ui/view/picture_size.h"
#include "ui/view/view_options.h"

#include <memory>
#include <vector>

namespace hanei {

/// What is drawn over the room in the window; nothing of it in exported pictures.
struct Highlights {
    std::vector<ObjectId> selected;
    ObjectId hovered;
    struct Line {
        Vec3 from{0.0}, to{0.0};
        glm::vec4 colour{1.0F};
    };
    std::vector<Line> lines;  ///< handles, guides
};

/// Needs     a current GL 3.3 core context whose functions were loaded (gladLoadGL), the same for
///           every call and for the destructor.
class Renderer {
public:
    Renderer();
    ~Renderer();

    void set_scene(SceneSnapshot scene);  ///< geometry that shows before any solution
    /// May be of an older scene: its light is drawn as it was, under the present scene's edges and
    /// luminaires. Null, or without a display mesh: plain faces.
    void set_solution(SolutionSnapshot solution);

    /// Draws into the framebuffer that is bound, over its whole `size`, background included. Leaves
    /// depth test, culling and blending off, no program and no vertex array bound.
    /// `room`, when given, is a picture of the lit surfaces of this size (exact_picture.h), shown in
    /// their place; luminaires, and lines but in photos, are drawn over it as over the surfaces.
    void draw(const Camera& camera, const ViewOptions& look, const Highlights& highlights, PixelSize size,
              const Image* room = nullptr);

private:
    struct Buffers;
    std::unique_ptr<Buffers> buffers_;
};

}  // namespace hanei
