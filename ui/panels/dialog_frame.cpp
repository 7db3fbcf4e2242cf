#include "ui/panels/dialog_frame.h"

#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

constexpr float button_width = 110.0F;

}  // namespace

bool begin_dialog(const std::string& label, float width, bool& opening, bool& stays) {
    if (opening) ImGui::OpenPopup(label.c_str());
    opening = false;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * screen.x, 0.5F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({std::min(width * style::scale(), screen.x - 40.0F), 0.0F});
    ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, {screen.x, screen.y - 60.0F});
    bool open = true;
    const bool drawn =
        ImGui::BeginPopupModal(label.c_str(), &open, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
    stays = drawn && open;
    return drawn;
}

void buttons_from_right(int count) {
    const float space = ImGui::GetStyle().ItemSpacing.x;
    const float width =
        static_cast<float>(count) * button_width * style::scale() + static_cast<float>(count - 1) * space;
    ImGui::Dummy({0.0F, 6.0F * style::scale()});
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - width);
}

bool dialog_button(const char* label, const char* name, WidgetRegistry& widgets) {
    const bool pressed =
        ImGui::Button(fmt::format("{}###{}", tr(label), name).c_str(), {button_width * style::scale(), 0.0F});
    widgets.note(name);
    return pressed;
}

bool escape_pressed() {
    return !ImGui::GetIO().WantTextInput && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
}

}  // namespace hanei
