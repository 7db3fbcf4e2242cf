/// The views kept with the project: recalled, brought up to date, put in order and thrown away.
#pragma once

#include "ui/panels/viewport.h"

namespace hanei {

struct ViewEdit {
    Scene scene;
    std::string step;  ///< its name in the history
};

/// The present picture as a new view, with a name that no other has.
ViewEdit with_kept_view(Scene scene, const Camera& camera);
ViewEdit with_updated_view(Scene scene, ObjectId view, const Camera& camera);  ///< keeps its name
ViewEdit with_view_moved_up(Scene scene, ObjectId view);                       ///< the first one stays the first
ViewEdit without_view(Scene scene, ObjectId view);

/// Rows of an open popup: a click recalls. Returns an edit when a button asked for one.
std::optional<ViewEdit> saved_view_rows(ViewState& state, const Scene& scene, WidgetRegistry& widgets);

}  // namespace hanei
