#include "ui/panels/widget_registry.h"

#include <imgui.h>

namespace hanei {

void WidgetRegistry::note(const std::string& name) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    rects_[name] = {low.x, low.y, high.x, high.y};
}

const ScreenRect* WidgetRegistry::find(const std::string& name) const {
    const auto found = rects_.find(name);
    return found == rects_.end() ? nullptr : &found->second;
}

}  // namespace hanei
