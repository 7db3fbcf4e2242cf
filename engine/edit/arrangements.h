/// Lines, fields and circles of luminaires: made, changed and taken apart.
#pragma once

#include "engine/edit/edit.h"
#include "engine/scene/layout.h"

#include <span>

namespace hanei {

/// Null when the id names none.
const Arrangement* find_arrangement(const Scene& scene, ObjectId id);

/// The arrangement the luminaire hangs in; null when it hangs by itself.
const Arrangement* arrangement_of(const Scene& scene, ObjectId luminaire);

/// The luminaires meant by these objects, each once: themselves, those of arrangements, of control
/// groups and of groups of objects.
std::vector<ObjectId> luminaires_among(const Scene& scene, std::span<const ObjectId> objects);

/// How many of its places have a luminaire.
std::size_t luminaires_in(const Arrangement& arrangement);
Vec3 middle_of(const Layout& layout);
Layout moved(Layout layout, const Vec3& by);

// Layouts to begin with, at this height: over the length, the whole, the middle of the room's plan.
Layout line_over_room(const Scene& scene, double z, int count);
Layout field_over_room(const Scene& scene, double z, int columns, int rows);
Layout circle_in_room(const Scene& scene, double z, int count);

/// An arrangement of luminaires like this one, which hangs at its first place. Places of a field that
/// lie outside the room's plan stay empty. A luminaire of another arrangement leaves it.
///
/// Needs     a luminaire of the scene.
/// Returns   the arrangement as the object that was added.
Added arranged(Scene scene, ObjectId luminaire, const Layout& layout);

/// The arrangement with another layout, every luminaire turned by `yaw` where it was by the old one:
/// luminaires keep their own settings by their number (in a field by row and column); new places get
/// copies of the first, places that are no more lose theirs. A place emptied by hand stays empty.
Scene with_layout(Scene scene, ObjectId arrangement, const Layout& layout, double yaw);

/// Its luminaires hang by themselves.
Scene dissolved(Scene scene, ObjectId arrangement);

/// How many places of the arrangement are empty because they lie outside the room's plan.
std::size_t places_outside(const Scene& scene, const Arrangement& arrangement);

/// What arrangements make of changed places: where all luminaires moved alike, the layout moved with
/// them; any other that is not at its place hangs by itself from now on.
Scene with_arrangements_kept(Scene scene);

}  // namespace hanei
