/// The properties of one object each. A panel reads the scene, draws itself, and returns the scene
/// it would rather have, or nothing. It keeps no copy and changes nothing.
///
/// Needs     an open form (Form::begin).
#pragma once

#include "engine/plan/settings.h"
#include "engine/scene/scene.h"
#include "ui/panels/form.h"

#include <optional>

namespace hanei {

std::optional<Scene> luminaire_panel(const Scene& scene, ObjectId id, Form& form);
std::optional<Scene> arrangement_panel(const Scene& scene, ObjectId id, Form& form);
std::optional<Scene> control_group_panel(const Scene& scene, ObjectId id, Form& form);
std::optional<Scene> light_scene_panel(const Scene& scene, ObjectId id, Form& form);
std::optional<Scene> furniture_panel(const Scene& scene, ObjectId id, Form& form);
std::optional<Scene> sub_area_panel(const Scene& scene, ObjectId id, Form& form);
std::optional<Scene> surface_panel(const Scene& scene, ObjectId id, Form& form);
std::optional<Scene> material_panel(const Scene& scene, ObjectId id, Form& form);
std::optional<Scene> grid_panel(const Scene& scene, ObjectId id, Form& form);
std::optional<Scene> point_panel(const Scene& scene, ObjectId id, Form& form);
std::optional<Scene> view_panel(const Scene& scene, ObjectId id, Form& form);

/// What belongs to no object: title, maintenance factor.
std::optional<Scene> project_panel(const Scene& scene, Form& form);

/// The panel of whatever object this is; the project's when it is none.
std::optional<Scene> object_panel(const Scene& scene, ObjectId id, Form& form);

/// How the scene is computed: method and every entry of `options`.
std::optional<Settings> settings_panel(const Settings& settings, Form& form);

}  // namespace hanei
