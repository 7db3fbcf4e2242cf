#include "ui/panels/task_bar.h"

#include "ui/panels/elided.h"
#include "ui/panels/form.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {

void task_bar(const Task& task, WidgetRegistry& widgets) {
    const float scale = style::scale();
    const char* const stop = tr(task.id == "recording" ? "Stop" : "Cancel");
    const float button = std::max(62.0F * scale, ImGui::CalcTextSize(stop).x + 12.0F * scale);
    std::string text(tr(std::string_view(task.name)));
    if (task.fraction > 0.0F) text += fmt::format("  {:.0f} %", 100.0F * task.fraction);
    if (!task.left.empty()) text += fmt::format(", {}", task.left);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {6.0F * scale, 1.0F * scale});
    const float width = (task_bar_width - 8.0F) * scale - (task.cancel ? button + 8.0F * scale : 0.0F);
    // Words are read over the bar, however far it is: it is pale, and they begin where it does.
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, style::faded(style::accent, 0.35F));
    ImGui::ProgressBar(task.fraction, {width, ImGui::GetTextLineHeight() + 2.0F * scale}, "");
    ImGui::PopStyleColor();
    widgets.note(task.id + ".progress");
    const ImVec2 at = ImGui::GetItemRectMin();
    const std::string shown = elided(text, width - 12.0F * scale);
    ImGui::GetWindowDrawList()->AddText({at.x + 6.0F * scale, at.y + scale}, style::text, shown.c_str());
    if (shown.size() != text.size()) tooltip(text);
    if (task.cancel) {
        ImGui::SameLine(0.0F, 8.0F * scale);
        if (ImGui::Button(fmt::format("{}###{}", stop, task.id).c_str(), {button, 0.0F})) task.cancel();
        widgets.note(task.id + ".cancel");
        tooltip(task.id == "file" ? "Stop this; all stays as it was" : "Stop this; what is done so far stays");
    }
    ImGui::PopStyleVar();
}

}  // namespace hanei
