/// A furnished room with light that is written down, not computed: the view is tested without the
/// engine.
#pragma once

#include "engine/solution/solution.h"

#include <functional>

namespace hanei::test {

/// 6 m x 4 m x 2.8 m, two desks, a cupboard, two ceiling panels, a line and a point.
Scene furnished_room();

/// Light at a place of a surface.
struct Light {
    double direct = 0.0, interreflected = 0.0, unshadowed = 0.0;
};
using LightField = std::function<Light(const Vec3& place, const Vec3& normal)>;

/// What the ceiling panels would give a little above the truth of a real room: inverse square with
/// both cosines, a soft glow from the walls, and a shadow under desks.
Light pleasant_light(const Vec3& place, const Vec3& normal);

/// Cuts all (four-cornered) faces into cells of about `width` and samples the field at corners.
std::shared_ptr<const Solution> solution_by_hand(const Scene& scene, const LightField& field, double width = 0.25);

/// One square of 2 m lying at z = 0 seen from above, one cell, with these corner values.
std::shared_ptr<const Solution> single_cell(const std::array<float, 4>& lux);

/// The same square of even light, cut so that corners of its cells lie on edges of others.
std::shared_ptr<const Solution> square_with_hanging_corners(float lux);

}  // namespace hanei::test
