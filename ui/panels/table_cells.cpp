#include "ui/panels/table_cells.h"

#include "ui/panels/elided.h"
#include "ui/panels/form.h"
#include "ui/panels/illuminance_text.h"
#include "ui/panels/language.h"

namespace hanei {
namespace {

void to_right(const char* text) {
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text).x;
    if (room > 0.0F) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room);
}

/// A title that ends in the unit ends in the one that is shown.
std::string in_shown_unit(const char* title) {
    std::string shown = tr(title);
    if (shown.ends_with("lx")) shown.replace(shown.size() - 2, 2, illuminance_unit_name());
    return shown;
}

}  // namespace

void header(std::span<const Column> columns) {
    for (const Column& column : columns) {
        ImGui::TableSetupColumn(column.title, ImGuiTableColumnFlags_WidthStretch, column.share);
    }
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (int k = 0; k < static_cast<int>(columns.size()); ++k) {
        const Column& column = columns[static_cast<std::size_t>(k)];
        const char* const title = tr(column.title);
        ImGui::TableSetColumnIndex(k);
        ImGui::PushStyleColor(ImGuiCol_Text, style::quiet_text);
        const std::string shown = in_shown_unit(title);
        if (column.figures) to_right(shown.c_str());
        ImGui::TextUnformatted(shown.c_str());
        ImGui::PopStyleColor();
        tooltip(column.help);
    }
}

void cell(const std::string& text, ImU32 colour) {
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    elided_text(text);
    ImGui::PopStyleColor();
}

void figure(const std::string& text) {
    ImGui::TableNextColumn();
    to_right(text.c_str());
    ImGui::TextUnformatted(text.c_str());
}

}  // namespace hanei
