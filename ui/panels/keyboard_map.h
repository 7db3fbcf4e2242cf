/// All keys by menu, and what the mouse does: in columns of nearly the same height.
#pragma once

#include "ui/panels/widget_registry.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hanei {

struct KeyGroup {
    struct Row {
        std::string keys;
        std::string_view what;
    };
    std::string_view title;  ///< of the menu
    std::vector<Row> rows;
};

/// Commands with keys in the order of the menus, those of no menu at the end; then the mouse.
std::vector<KeyGroup> keyboard_map();

/// How many of these heights, in their order, stand in the first of two columns so that the higher one
/// is as low as can be.
std::size_t balanced(std::span<const float> heights);

/// At most this high (pixels): rolled where it is higher. One column where two have no room.
void draw_keyboard_map(float greatest_height, WidgetRegistry& widgets);

}  // namespace hanei
