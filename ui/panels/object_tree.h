/// The list of everything in the project.
#pragma once

#include "engine/edit/several.h"
#include "ui/panels/selection.h"
#include "ui/panels/widget_registry.h"

#include <optional>

namespace hanei {

/// A click chooses a row, Ctrl+click joins it or leaves it, Shift+click takes all rows between. What
/// is chosen elsewhere is shown: its branch opens and the list rolls to it.
class ObjectTree {
public:
    struct Outcome {
        std::optional<Selection> chosen;
        bool menu_wished = false;  ///< the row was clicked with the right button
    };

    /// Draws into the present ImGui window.
    Outcome draw(const Scene& scene, const Selection& selection, WidgetRegistry& widgets);

private:
    ObjectId shown_;   ///< the primary object that the list was last rolled to
    ObjectId anchor_;  ///< where a range begins
};

}  // namespace hanei
