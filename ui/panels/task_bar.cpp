#include "ui/panels/task_bar.h"

#include "ui/panels/form.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <fmt/format.h>
#include <imgui.h>

namespace hanei {

void task_bar(const Task& task, WidgetRegistry& widgets) {
    const float scale = style::scale();
    const float button = 62.0F * scale;
    std::string text = task.name;
    if (task.fraction > 0.0F) text += fmt::format("  {:.0f} %", 100.0F * task.fraction);
    if (!task.left.empty()) text += fmt::format(", {}", task.left);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {6.0F * scale, 1.0F * scale});
    const float width = (task_bar_width - 8.0F) * scale - (task.cancel ? button + 8.0F * scale : 0.0F);
    ImGui::ProgressBar(task.fraction, {width, ImGui::GetTextLineHeight() + 2.0F * scale}, text.c_str());
    widgets.note(task.id + ".progress");
    if (task.cancel) {
        ImGui::SameLine(0.0F, 8.0F * scale);
        if (ImGui::Button(fmt::format("{}###{}", tr(task.id == "recording" ? "Stop" : "Cancel"), task.id).c_str(),
                          {button, 0.0F}))
            task.cancel();
        widgets.note(task.id + ".cancel");
        tooltip(task.id == "file" ? "Stop this; all stays as it was" : "Stop this; what is done so far stays");
    }
    ImGui::PopStyleVar();
}

}  // namespace hanei
