/// Where a room is looked at from, by the names of drawings: plan, front, side.
#pragma once

#include "ui/view/camera.h"

#include <array>
#include <optional>
#include <string_view>

namespace hanei {

/// Fronts are looked at from outside, through the wall that stands before them: the front from -y
/// (south, at the lower edge of a plan), the right side from +x.
enum class Standpoint { overview, plan, ceiling_plan, front, back, left, right };

inline constexpr std::array standpoints{Standpoint::overview, Standpoint::plan, Standpoint::ceiling_plan,
                                        Standpoint::front,    Standpoint::back, Standpoint::left,
                                        Standpoint::right};

std::string_view name_of(Standpoint standpoint);  ///< "Ceiling plan"
std::string_view word_of(Standpoint standpoint);  ///< "ceiling-plan", as the command line says it

/// Shows all of the bounds with a small margin. All but the overview are parallel projections along
/// an axis: straight lines of the room stay straight across or up the picture, and to scale.
Camera camera_at(Standpoint standpoint, const Bounds& bounds, double aspect);

/// From where a camera looks to scale along an axis; empty for all others.
std::optional<Standpoint> standpoint_of(const Camera& camera);

}  // namespace hanei
