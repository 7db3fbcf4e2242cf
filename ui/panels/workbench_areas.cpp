#include "ui/panels/edit.h"
#include "ui/panels/object_tree.h"
#include "ui/panels/panel_frame.h"
#include "ui/panels/properties.h"
#include "ui/panels/results_panel.h"
#include "ui/panels/style.h"
#include "ui/panels/view_bar.h"
#include "ui/panels/workbench.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

void headline(const std::string& text, std::string_view quiet) {
    ImGui::PushFont(style::fonts().strong);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopFont();
    if (!quiet.empty()) {
        ImGui::SameLine();
        ImGui::TextColored(style::colour(style::quiet_text), "%.*s", static_cast<int>(quiet.size()), quiet.data());
    }
    ImGui::Dummy({0.0F, 2.0F * style::scale()});
}

bool begin_tab(const char* label, WidgetRegistry& widgets, std::size_t count = 0) {
    const std::string shown = count == 0 ? label : fmt::format("{}  {}", label, count);
    const bool open = ImGui::BeginTabItem((shown + "###" + label).c_str());
    widgets.note(std::string("tab.") + label);
    return open;
}

std::string step_name(const Scene& scene, ObjectId id) {
    const ObjectKind kind = kind_of(scene, id);
    return kind == ObjectKind::none ? "Change project" : "Change " + std::string(name_of(kind));
}

}  // namespace

void Workbench::menu_bar() {
    if (!ImGui::BeginMainMenuBar()) return;
    std::string_view menu;
    bool open = false;
    for (const Command& entry : commands()) {
        if (entry.menu.empty()) continue;
        if (entry.menu != menu) {
            if (open) ImGui::EndMenu();
            menu = entry.menu;
            open = ImGui::BeginMenu(std::string(menu).c_str());
            widgets_.note("menu." + std::string(menu));
        }
        if (!open) continue;
        if (entry.starts_section) ImGui::Separator();
        std::string label(entry.label);
        if (entry.id == CommandId::undo && can(entry.id)) label += " " + document_.history().undo_name();
        if (entry.id == CommandId::redo && can(entry.id)) label += " " + document_.history().redo_name();
        const bool ticked =
            (entry.id == CommandId::toggle_snap && snaps_) ||
            (entry.id == CommandId::four_up && viewport_.state.four_up) ||
            (entry.id == CommandId::toggle_shadow_classes && viewport_.state.options.shadow_classes) ||
            (entry.id == CommandId::toggle_shadow_outlines && viewport_.state.options.shadow_outlines) ||
            (entry.id == CommandId::toggle_isolux && viewport_.state.options.isolux) ||
            (entry.id == CommandId::toggle_photo && viewport_.state.options.scale == Scale::photo);
        const bool wished = ImGui::MenuItem((label + "###" + std::string(entry.name)).c_str(),
                                            to_text(entry.chord).c_str(), ticked, can(entry.id));
        widgets_.note(std::string(entry.name));
        tooltip(std::string(entry.help));
        if (wished) carry_out(entry.id);
    }
    if (open) ImGui::EndMenu();
    const std::string name = (document_.is_saved() ? "" : "•  ") + document_.title();
    const float width = ImGui::CalcTextSize(name.c_str()).x;
    ImGui::SameLine(ImGui::GetWindowWidth() - width - 28.0F * style::scale());
    ImGui::TextColored(style::colour(style::quiet_text), "%s", name.c_str());
    tooltip(document_.is_saved() ? "Saved" : "Has changes that were not saved");
    ImGui::EndMainMenuBar();
}

void Workbench::left(const ScreenRect& area) {
    begin_panel("##left", area);
    movable_edge(Edge::right, area, left_width_, 140.0F, 420.0F);
    headline("Objects", "");
    ImGui::BeginChild("tree");
    if (const auto clicked = object_tree(*document_.shown(), selected_, widgets_)) selected_ = *clicked;
    if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::IsAnyItemHovered())
        selected_ = {};
    ImGui::EndChild();
    end_panel();
}

void Workbench::properties_tab() {
    const SceneSnapshot scene = document_.shown();
    const ObjectKind kind = kind_of(*scene, selected_);
    ImGui::Dummy({0.0F, 2.0F * style::scale()});
    if (kind == ObjectKind::none)
        headline("Project", "");
    else
        headline(display_name(*scene, selected_), name_of(kind));
    ImGui::PushID(static_cast<int>(selected_.value));
    form_.begin("properties");
    std::optional<Scene> wished = object_panel(*scene, selected_, form_);
    form_.end();
    ImGui::PopID();
    if (wished) propose(std::move(*wished), step_name(*scene, selected_));
}

void Workbench::photometry_tab() {
    ImGui::PushID(static_cast<int>(selected_.value));
    PhotometryPanel::Outcome outcome = photometry_.draw(*document_.shown(), selected_, form_);
    ImGui::PopID();
    if (outcome.edit) propose(std::move(outcome.edit->scene), std::move(outcome.edit->step));
    if (outcome.replaces_file) replace_luminaire_file();
}

void Workbench::right(const ScreenRect& area) {
    begin_panel("##right", area);
    movable_edge(Edge::left, area, right_width_, 220.0F, 520.0F);
    if (ImGui::BeginTabBar("sides")) {
        if (begin_tab("Properties", widgets_)) {
            ImGui::BeginChild("fields");
            properties_tab();
            ImGui::EndChild();
            ImGui::EndTabItem();
        }
        if (begin_tab("Photometry", widgets_)) {
            ImGui::BeginChild("photometry");
            photometry_tab();
            ImGui::EndChild();
            ImGui::EndTabItem();
        }
        if (begin_tab("Calculation", widgets_)) {
            ImGui::BeginChild("settings");
            ImGui::Dummy({0.0F, 2.0F * style::scale()});
            form_.begin("settings");
            if (const auto wished = settings_panel(document_.settings(), form_)) document_.set_settings(*wished);
            form_.end();
            ImGui::EndChild();
            ImGui::EndTabItem();
        }
        ImGui::EndTabBar();
    }
    end_panel();
}

void Workbench::bottom(const ScreenRect& area) {
    begin_panel("##bottom", area);
    movable_edge(Edge::top, area, bottom_height_, 90.0F, 460.0F);
    const SolutionSnapshot solution = study_.answer();  // results on the way have no values yet
    const bool measured = !how_.repeatable;
    if (ImGui::BeginTabBar("tables")) {
        if (begin_tab("Results", widgets_)) {
            const bool any = solution && (!solution->grids.empty() || !solution->points.empty());
            if (!solution)
                ImGui::TextDisabled("The first values are being computed.");
            else if (!any)
                ImGui::TextDisabled("No calculation grid or point yet: Add > Calculation grid.");
            else if (const auto clicked = results_table(*solution, selected_, widgets_))
                selected_ = *clicked;
            ImGui::EndTabItem();
        }
        if (begin_tab("Effects", widgets_)) {
            if (solution) effects_table(solution->plan, measured);
            ImGui::EndTabItem();
        }
        if (begin_tab("Energy", widgets_)) {
            if (solution) energy_table(*solution, measured);
            ImGui::EndTabItem();
        }
        const std::size_t found = study_.findings().size();
        if (begin_tab("Checks", widgets_, found)) {
            if (found == 0) ImGui::TextDisabled("Nothing is wrong with the scene.");
            if (const auto clicked = findings_table(*document_.shown(), study_.findings(), widgets_))
                selected_ = *clicked;
            ImGui::EndTabItem();
        }
        ImGui::EndTabBar();
    }
    end_panel();
}

void Workbench::centre(const ScreenRect& area, const ViewPainter& paint) {
    const float scale = style::scale();
    const float bar = ImGui::GetFrameHeight() + 12.0F * scale;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {8.0F * scale, 6.0F * scale});
    begin_panel("##bar", {area.left, area.top, area.right, area.top + bar});
    ImGui::PopStyleVar();
    view_bar(viewport_.state, *document_.shown(), study_.solution(), widgets_);
    end_panel();
    const ScreenRect view{area.left, area.top + bar, area.right, area.bottom};
    ImGui::PushStyleColor(ImGuiCol_WindowBg, style::ground);
    begin_panel("##view", view, false);
    const Viewport::Input input{document_.shown(), study_.solution(), study_.answer(),
                                selected_,         raster(),          !study_.fresh()};
    const Viewport::Outcome outcome = viewport_.draw(input, paint, widgets_);
    if (viewport_.shown_options(input).shadow_classes)
        class_legend(viewport_.shown_options(input), study_.solution(), view, widgets_);
    else
        legend(viewport_.state, view, widgets_);
    end_panel();
    ImGui::PopStyleColor();
    if (outcome.chosen) selected_ = *outcome.chosen;
    if (outcome.moved)
        document_.propose(*outcome.moved, "Move " + std::string(name_of(kind_of(*outcome.moved, selected_))));
    if (outcome.released) document_.settle();
}

}  // namespace hanei
