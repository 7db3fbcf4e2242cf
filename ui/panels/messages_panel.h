/// Everything that is wrong or was, in one list.
#pragma once

#include "engine/scene/scene.h"
#include "ui/panels/messages.h"
#include "ui/panels/widget_registry.h"

#include <optional>

namespace hanei {

/// First what is wrong with the scene as it is, then what happened, the newest first. What is hard in the scene
/// stands there too once it was asked for, until the list is cleared, and follows the scene.
class MessagesPanel {
public:
    void list_hard_spots() { lists_hard_spots_ = true; }

    /// `findings`, and where they are listed, how many there are of each kind before and the hard spots after them.
    /// They are looked for when the scene is another than the last time. Holds until the next call.
    const Diagnostics& checks_of(const SceneSnapshot& scene, const Diagnostics& findings);

    /// `timed` shows when each came; pictures that shall repeat leave it out.
    /// Returns the object of a message that was clicked.
    std::optional<ObjectId> draw(const Scene& scene, const Diagnostics& checks, Messages& messages, bool timed,
                                 WidgetRegistry& widgets);

private:
    struct Row {
        std::string time, source;
        Diagnostic finding;
        int count = 1;
    };
    std::vector<Row> rows(const Diagnostics& checks, const Messages& messages, bool timed) const;
    void tools(const std::vector<Row>& shown, Messages& messages, WidgetRegistry& widgets);

    bool lists_hard_spots_ = false;
    SceneSnapshot looked_at_;  ///< whose hard spots these are
    Diagnostics spots_, checks_;
    int least_ = 0;  ///< 0 all, 1 warnings and errors, 2 errors
    std::string words_;
};

}  // namespace hanei
