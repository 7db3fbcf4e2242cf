/// Furniture of the library in a scene.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/edit/edit.h"
#include "engine/edit/furniture_library.h"
#include "engine/scene/faces.h"

#include <string>
#include <string_view>

namespace hanei {

/// A piece by itself, at the origin, its materials found in the scene by name or added to it.
///
/// Needs     a kind of the library.
Furniture made_furniture(Scene& scene, const FurnitureModel& model);

/// The piece at this place, turned by `rotation` (rad, about z). A column is as high as the room.
///
/// Returns   the scene as it was and no object when the library has no such kind.
Added with_furniture(Scene scene, const FurnitureModel& model, const Vec3& place, double rotation = 0.0);

/// The piece where there is room for it: what stands on furniture on the chosen piece, if that has a top
/// to stand on; everything else on the floor, as near to the middle of the room as nothing stands yet.
Added with_furniture(Scene scene, const FurnitureModel& model, ObjectId chosen = {});

/// Whether the parts are those that the model makes, whatever covers them.
bool follows_model(const Furniture& furniture);

/// The piece with another size and the parts that follow. Parts keep their materials by what they are of;
/// new ones are covered as the last of their kind.
void set_model_size(Furniture& furniture, std::string_view size, double value);

/// One material for all parts of a finish; none of them when the piece has no model.
void set_finish(Furniture& furniture, int finish, ObjectId material);
/// That all parts of a finish have; nothing when they differ.
ObjectId material_of_finish(const Furniture& furniture, int finish);

/// Takes the model of pieces whose parts were edited by themselves; says so for each as a warning, and
/// for those whose kind the library does not know, which keep it. Parts always stay.
Diagnostics settle_models(Scene& scene);

/// Bounds of the piece in its own frame. Nothing at all for a piece without parts.
Bounds own_bounds(const Furniture& furniture);

}  // namespace hanei
