/// The list of everything in the project.
#pragma once

#include "engine/scene/scene.h"
#include "ui/panels/widget_registry.h"

#include <optional>

namespace hanei {

/// Returns what was clicked, or nothing.
std::optional<ObjectId> object_tree(const Scene& scene, ObjectId selected, WidgetRegistry& widgets);

}  // namespace hanei
