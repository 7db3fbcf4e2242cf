/// Finds a command by what it is called: type, choose, Enter.
#pragma once

#include "ui/panels/command.h"
#include "ui/panels/widget_registry.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace hanei {

/// Commands whose label, menu or help hold all of the words, in any case; the best first: those whose
/// label begins with the text, then those whose label holds it, then the rest in the order of menus.
std::vector<const Command*> commands_matching(std::string_view text);

class CommandSearch {
public:
    void open() { opening_ = true; }
    bool is_open() const { return open_ || opening_; }

    /// The command that was chosen in this frame. Those that `can` refuses are shown grey.
    std::optional<CommandId> draw(const std::function<bool(CommandId)>& can, WidgetRegistry& widgets);

private:
    bool opening_ = false, open_ = false;
    std::string text_;
    int row_ = 0;
};

}  // namespace hanei
