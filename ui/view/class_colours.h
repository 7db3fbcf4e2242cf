/// How the classes of patches look, in pictures and in their keys.
#pragma once

#include <glm/vec3.hpp>

#include <array>

namespace hanei {

/// Colours of the classes, in the order of LightClass. They differ in lightness, so that no hue is
/// needed; `partly` is hatched besides.
inline constexpr std::array<glm::vec3, 4> class_colours{glm::vec3{0.56F, 0.57F, 0.59F}, glm::vec3{0.20F, 0.23F, 0.30F},
                                                        glm::vec3{0.80F, 0.83F, 0.85F},
                                                        glm::vec3{0.985F, 0.97F, 0.91F}};
inline constexpr glm::vec3 hatching_colour{0.55F, 0.60F, 0.66F};
inline constexpr double hatching_px = 7.0;  ///< pixels of a picture 900 high

}  // namespace hanei
