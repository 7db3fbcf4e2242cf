/// Draws a room and its light with OpenGL 3.3 core.
///
/// Cells are interpolated bilinearly in the fragment shader from their four corner values (the
/// paper's equation 6), so that no diagonal shows. Faces are seen from their lit side only: a room
/// looked at from outside opens like a doll's house.
#pragma once

#include "engine/solution/solution.h"
#include "ui/view/camera.h"
#include "ui/view/view_options.h"

#include <memory>
#include <vector>

namespace hanei {

struct PixelSize {
    int width = 0, height = 0;
    bool operator==(const PixelSize&) const = default;
};

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

/// Needs     a current GL 3.3 core context whose functions were loaded, the same for every call.
class Renderer {
public:
    Renderer();
    ~Renderer();

    void set_scene(SceneSnapshot scene);           ///< geometry that shows before any solution
    void set_solution(SolutionSnapshot solution);  ///< may be of an older scene: drawn as it was

    /// Draws into the framebuffer that is bound, over its whole `size`.
    void draw(const Camera& camera, const ViewOptions& options, const Highlights& highlights, PixelSize size);

private:
    struct Buffers;
    std::unique_ptr<Buffers> buffers_;
};

}  // namespace hanei
