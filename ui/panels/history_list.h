/// The steps that can be taken back and made again; a click goes there.
#pragma once

#include "ui/panels/edit_history.h"
#include "ui/panels/widget_registry.h"

#include <optional>

namespace hanei {

class HistoryList {
public:
    void open() { opening_ = true; }

    /// The step that was chosen in this frame.
    std::optional<std::size_t> draw(const EditHistory& history, WidgetRegistry& widgets);

private:
    bool opening_ = false;
};

}  // namespace hanei
