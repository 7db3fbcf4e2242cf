/// Tables of figures: a header that explains, cells that shorten, figures to the right.
#pragma once

#include "ui/panels/style.h"

#include <imgui.h>
#include <span>
#include <string>

namespace hanei {

constexpr int table_look =
    ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp;

struct Column {
    const char* title;
    float share;
    const char* help;
    bool figures = false;  ///< right-aligned
};

/// The first row of the present table, which stays when the table scrolls. A title that ends in the unit of
/// illuminance ends in the one that is shown.
void header(std::span<const Column> columns);

// The next cell of the present row.
void cell(const std::string& text, ImU32 colour = style::text);
void figure(const std::string& text);

}  // namespace hanei
