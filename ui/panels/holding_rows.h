/// Rows by which luminaires are held and aimed, for one, for several and for arrangements.
#pragma once

#include "engine/scene/scene.h"
#include "ui/panels/form.h"

#include <optional>
#include <span>

namespace hanei {

/// How they are held: recessed, pendant, on the wall... and the length or height that goes with it.
///
/// Needs     at least one luminaire of the scene; the first is shown.
std::optional<Scene> mounting_rows(const Scene& scene, std::span<const ObjectId> luminaires, Form& form);

/// Where their light meets something, as three numbers that can be typed.
std::optional<Scene> aim_rows(const Scene& scene, std::span<const ObjectId> luminaires, Form& form);

}  // namespace hanei
