/// Changes to a scene as the window makes them: a scene in, a scene out.
#pragma once

#include "engine/scene/scene.h"

#include <optional>
#include <string>

namespace hanei {

enum class ObjectKind {
    none,
    room,
    furniture,
    surface,
    luminaire,
    grid,
    point,
    view,
    material,
    control_group,
    light_scene,
    arrangement,
    object_group,
    sub_area,
};

ObjectKind kind_of(const Scene& scene, ObjectId id);
std::string_view name_of(ObjectKind kind);  ///< "luminaire", "calculation grid", ...

/// What the window calls an object: its name, or its kind and id when it has none.
std::string display_name(const Scene& scene, ObjectId id);

/// The object of this display name; 0 when there is none.
ObjectId object_named(const Scene& scene, const std::string& name);

/// Where the object is held when it is moved: a luminaire's or piece of furniture's own place, the
/// middle of a grid, a surface, a group or an arrangement. Empty for what does not move (rooms,
/// materials, views).
std::optional<Vec3> place_of(const Scene& scene, ObjectId id);

/// As moved() of several objects (several.h) does.
Scene moved(Scene scene, ObjectId id, const Vec3& by);

/// Without the object. Materials and the room stay: other things rest on them.
Scene removed(Scene scene, ObjectId id);
bool can_remove(ObjectKind kind);

struct Added {
    Scene scene;
    ObjectId object;
};

/// New objects appear in the middle of the room: luminaires below its ceiling, boxes on its floor,
/// grids and points at desk height.
Added with_point_luminaire(Scene scene);
Added with_line_luminaire(Scene scene);
Added with_panel_luminaire(Scene scene);
Added with_measured_luminaire(Scene scene, Photometry photometry);
Added with_box(Scene scene);
Added with_grid(Scene scene);
Added with_calculation_point(Scene scene);

/// A closed, unlit box to begin with: 6 m x 4 m x 2.8 m, ceiling 70 %, walls 50 %, floor 20 %.
Scene empty_room();

}  // namespace hanei
