/// Where light can start or arrive in a scene, and what can stand in its way.
#pragma once

#include "engine/geometry/configuration_factor.h"
#include "engine/scene/faces.h"

#include <span>
#include <string>
#include <vector>

namespace hanei {

/// Calculation points, points first and then grids, row by row; none where they are more than 600.
std::vector<Receiver> few_calculation_points(const Scene& scene);

/// Corners of all faces, the luminaires' extents, points and grids: everything of the scene lies in
/// their convex hull.
std::vector<Vec3> places_of(const Scene& scene, std::span<const Face> faces);

/// True when one of the places lies behind the plane of a face by more than `same_place`: only then
/// can the face hide something.
bool has_something_behind(const Face& face, std::span<const Vec3> places, double same_place);

/// The room's faces and free surfaces that can hide something.
std::vector<Face> sheets_in_the_way(const Scene& scene);

/// What may stand between two places, in words for the plan ("12 solids, 2 walls"); empty when
/// nothing can, which is decided on the safe side.
std::string obstacles_of(const Scene& scene);

}  // namespace hanei
