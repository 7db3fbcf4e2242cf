/// The picture's figures without OpenGL: for every pixel which surface is seen and how much light
/// arrives there. Places for labels are chosen on it.
#pragma once

#include "ui/view/camera.h"
#include "ui/view/picture_size.h"
#include "ui/view/view_options.h"

#include <vector>

namespace hanei {

struct ValueBuffer {
    static constexpr int nothing = -1;    ///< background
    static constexpr int luminaire = -2;  ///< a luminous opening, or furniture that is cut, covers what lies behind

    PixelSize size;
    std::vector<float> lux;
    std::vector<float> depth;  ///< m along the line of sight
    std::vector<int> face;     ///< into Mesh::faces, or one of the above

    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
    }
};

/// Values are those of the pixels' centres, exact in perspective.
/// Needs     a solution with mesh and display mesh.
/// Cost      10 ms for 20 000 cells at 400 x 250.
ValueBuffer value_buffer(const Solution& solution, const Camera& camera, const ViewOptions& options, PixelSize size);

}  // namespace hanei
