#include "ui/panels/history_list.h"

#include "ui/panels/form.h"
#include "ui/panels/language.h"
#include "ui/panels/panel_frame.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {

std::optional<std::size_t> HistoryList::draw(const EditHistory& history, WidgetRegistry& widgets) {
    const float scale = style::scale();
    const bool just_opened = opening_;
    if (opening_) ImGui::OpenPopup("###history");
    opening_ = false;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * screen.x, 90.0F * scale}, ImGuiCond_Always, {0.5F, 0.0F});
    ImGui::SetNextWindowSize({std::min(420.0F * scale, screen.x - 40.0F), 0.0F});
    if (!ImGui::BeginPopup("###history")) return std::nullopt;
    headline(tr("History"), fmt::format("{}", history.depth()));
    constexpr std::size_t most_rows = 14;
    const auto rows = static_cast<float>(std::min(history.size(), most_rows));
    ImGui::BeginChild("steps", {0.0F, rows * ImGui::GetTextLineHeightWithSpacing() + 4.0F * scale});
    std::optional<std::size_t> wished;
    for (std::size_t k = 0; k < history.size(); ++k) {
        const std::string name = k == 0 ? tr("As it was opened") : phrase(history.name_of(k));
        const bool undone = k > history.depth();
        ImGui::PushStyleColor(ImGuiCol_Text, undone ? style::quiet_text : style::text);
        if (ImGui::Selectable(fmt::format("{}##{}", name, k).c_str(), k == history.depth(),
                              ImGuiSelectableFlags_DontClosePopups))
            wished = k;
        ImGui::PopStyleColor();
        widgets.note(fmt::format("history.{}", k));
        tooltip("Go to this step: later ones are taken back and can be made again");
        if (just_opened && k == history.depth()) ImGui::SetScrollHereY();
    }
    ImGui::EndChild();
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return wished;
}

}  // namespace hanei
