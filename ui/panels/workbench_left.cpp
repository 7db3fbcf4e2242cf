#include "ui/panels/panel_frame.h"
#include "ui/panels/window_layout.h"
#include "ui/panels/workbench.h"

#include <imgui.h>

namespace hanei {

void Workbench::left(const WindowLayout& layout) {
    const ScreenRect& area = layout.left;
    begin_panel("##left", area);
    if (layout.stacked)
        movable_edge(Edge::left, area, preferences_.right_width, 220.0F, 520.0F);
    else
        movable_edge(Edge::right, area, preferences_.left_width, 140.0F, 420.0F);
    if (begin_tabs("lists")) {
        if (begin_tab("Objects", widgets_)) {
            objects_tab();
            ImGui::EndTabItem();
        }
        if (begin_tab("Furniture", widgets_, 0, furnishing_.takes_library_wish())) {
            ImGui::BeginChild("library");
            furniture_tab();
            ImGui::EndChild();
            ImGui::EndTabItem();
        }
        end_tabs();
    }
    end_panel();
}

void Workbench::objects_tab() {
    ImGui::BeginChild("tree");
    const ObjectTree::Outcome clicked = tree_.draw(*document_.shown(), selection_, widgets_);
    if (clicked.chosen) {
        selection_ = *clicked.chosen;
        for (const View& view : document_.shown()->views)
            if (view.id == selection_.primary() && !clicked.menu_wished) viewport_.state.go_to(camera_of(view));
    }
    if (clicked.menu_wished) open_context_menu(selection_);
    if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::IsAnyItemHovered())
        selection_.clear();
    ImGui::EndChild();
}

}  // namespace hanei
