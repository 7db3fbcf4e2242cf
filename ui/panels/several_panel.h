/// One panel for several objects of a kind: rows in which they differ show "mixed", and an edit of a
/// row changes all of them.
#pragma once

#include "engine/edit/several.h"
#include "ui/panels/properties.h"
#include "ui/panels/selection.h"

namespace hanei {

class SeveralPanel {
public:
    /// The panel of the selection's primary object, standing for all of the selection that are of its
    /// kind. Names that are changed together are numbered.
    ///
    /// Needs     an open form.
    /// Cost      a run of the panel an object when scene or selection changed, or a row was edited.
    std::optional<Scene> draw(const SceneSnapshot& scene, const Selection& selection, Form& form);

private:
    void read(const Scene& scene, const ObjectIds& others, Form& form);

    SceneSnapshot read_scene_;
    Selection read_selection_;
};

/// The objects of the selection that are of its primary object's kind, without that one.
ObjectIds others_alike(const Scene& scene, const Selection& selection);

}  // namespace hanei
