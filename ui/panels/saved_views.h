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
/// Blanks around the name do not count; one that is nothing else, or another view's, changes nothing.
ViewEdit with_renamed_view(Scene scene, ObjectId view, const std::string& name);
ViewEdit with_view_moved_up(Scene scene, ObjectId view);  ///< the first one stays the first
ViewEdit without_view(Scene scene, ObjectId view);

/// Rows of an open popup: a click recalls; beneath the row that is being edited, its name and what of the
/// room it shows. The picture follows a view that it shows. Returns an edit when one is asked for; several
/// in a row are one gesture while a widget is held.
std::optional<ViewEdit> saved_view_rows(ViewState& state, const Scene& scene, WidgetRegistry& widgets);

}  // namespace hanei
