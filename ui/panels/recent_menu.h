/// The projects that were opened last, as a menu in the menu.
#pragma once

#include "ui/panels/widget_registry.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace hanei {

/// Which of them are there: asked once when the menu opens, since a sleeping disk may take its time.
class RecentMenu {
public:
    /// Within an open menu. Returns the project that was clicked.
    std::optional<std::filesystem::path> draw(std::vector<std::filesystem::path>& recent, WidgetRegistry& widgets);

private:
    std::vector<bool> there_;
};

}  // namespace hanei
