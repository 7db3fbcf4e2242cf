/// The menu of the right button: the commands that make sense where it was pressed.
#pragma once

#include "engine/edit/several.h"
#include "ui/panels/command.h"
#include "ui/panels/widget_registry.h"

#include <functional>
#include <optional>
#include <vector>

namespace hanei {

/// The commands for a selection of this kind; with `none` those of empty ground. An entry of `quit`,
/// which stands in no such menu, is a line between two sections.
std::vector<CommandId> context_commands(ObjectKind kind);

class ContextMenu {
public:
    void open(ObjectKind kind);

    /// The command that was chosen in this frame. Those that `can` refuses are left out.
    std::optional<CommandId> draw(const std::function<bool(CommandId)>& can, WidgetRegistry& widgets);

private:
    ObjectKind kind_ = ObjectKind::none;
    bool opening_ = false;
};

}  // namespace hanei
