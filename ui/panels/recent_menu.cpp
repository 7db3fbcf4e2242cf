#include "ui/panels/recent_menu.h"

#include "ui/panels/form.h"
#include "ui/panels/language.h"
#include "ui/panels/start_page.h"

#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
std::optional<std::filesystem::path> RecentMenu::draw(std::vector<std::filesystem::path>& recent,
                                                      WidgetRegistry& widgets) {
    std::optional<std::filesystem::path> clicked;
    const bool open = ImGui::BeginMenu(fmt::format("{}###file.recent", tr("Open recent")).c_str(), !recent.empty());
    widgets.note("file.recent");
    tooltip(recent.empty() ? "No project was opened yet" : "The projects that were opened last");
    if (!open) return clicked;
    if (ImGui::IsWindowAppearing() || there_.size() != recent.size()) {
        there_.clear();
        std::error_code unknown;
        for (const std::filesystem::path& project : recent)
            there_.push_back(std::filesystem::is_regular_file(project, unknown));
    }
    for (std::size_t k = 0; k < recent.size(); ++k) {
        const std::string name = recent[k].filename().string();
        const std::string label = fmt::format("{}###recent{}", name, k);
        if (ImGui::MenuItem(label.c_str(), short_folder(recent[k]).c_str(), false, there_[k])) clicked = recent[k];
        widgets.note("recent." + name);
        tooltip(there_[k] ? recent[k].string() : fmt::format(fmt::runtime(tr("{} is gone")), recent[k].string()));
    }
    ImGui::Separator();
    if (ImGui::MenuItem(fmt::format("{}###clear", tr("Clear this list")).c_str())) recent.clear();
    widgets.note("recent.clear");
    ImGui::EndMenu();
    return clicked;
}

}  // namespace hanei
