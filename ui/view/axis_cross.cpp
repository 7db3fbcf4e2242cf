#include "ui/view/axis_cross.h"

#include <algorithm>

namespace hanei {

std::array<AxisMark, 6> axis_marks(const Camera& camera) {
    const CameraAxes axes = axes_of(camera);
    std::array<AxisMark, 6> marks;
    for (int k = 0; k < 6; ++k) {
        Vec3 direction(0.0);
        direction[k / 2] = k % 2 == 0 ? 1.0 : -1.0;
        marks[static_cast<std::size_t>(k)] = {k / 2, k % 2 == 0,
                                              Vec2(glm::dot(direction, axes.right), -glm::dot(direction, axes.up)),
                                              glm::dot(direction, axes.forward)};
    }
    std::stable_sort(marks.begin(), marks.end(),
                     [](const AxisMark& a, const AxisMark& b) { return a.depth > b.depth + 1e-9; });
    return marks;
}

}  // namespace hanei
