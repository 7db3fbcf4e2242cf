#include "ui/panels/compare_panel.h"

#include "ui/panels/elided.h"
#include "ui/panels/form.h"
#include "ui/panels/illuminance_text.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

namespace hanei {
namespace {

constexpr float list_width = 312.0F;

bool choice(const char* label, const char* name, bool on, const char* help, WidgetRegistry& widgets) {
    const bool pressed = ImGui::RadioButton(fmt::format("{}##{}", tr(label), name).c_str(), on);
    widgets.note(name);
    tooltip(tr(help));
    return pressed;
}

void show_choices(Snapshots& snapshots, WidgetRegistry& widgets) {
    using Show = Snapshots::Show;
    struct Choice {
        Show show;
        const char *label, *name, *help;
    };
    const Choice choices[] = {
        {Show::now, "Now", "compare.now", "Show the room as it is"},
        {Show::a, "A", "compare.a", "Show A. Holding the key ` shows it too, for as long as it is held"},
        {Show::b, "B", "compare.b", "Show B"},
        {Show::difference, "B − A", "compare.difference",
         "Show how much more or less light there is in B (or now, while no B is kept) than in A"}};
    for (const Choice& each : choices) {
        if (choice(each.label, each.name, snapshots.show == each.show, each.help, widgets)) snapshots.show = each.show;
        ImGui::SameLine();
    }
    ImGui::NewLine();
}

/// The kept solutions, each with what it is: A, B or neither.
void kept_list(Snapshots& snapshots, CompareWish& wish, WidgetRegistry& widgets) {
    std::optional<std::size_t> removed;
    for (std::size_t k = 0; k < snapshots.list().size(); ++k) {
        KeptSolution& kept = snapshots.list()[k];
        ImGui::PushID(static_cast<int>(k));
        if (choice("A", fmt::format("compare.{}.a", k + 1).c_str(), snapshots.a() == k, "Compare this as A", widgets))
            snapshots.set_a(snapshots.a() == k ? std::nullopt : std::optional(k));
        ImGui::SameLine();
        if (choice("B", fmt::format("compare.{}.b", k + 1).c_str(), snapshots.b() == k, "Compare this as B", widgets))
            snapshots.set_b(snapshots.b() == k ? std::nullopt : std::optional(k));
        ImGui::SameLine();
        ImGui::SetNextItemWidth(130.0F * style::scale());
        ImGui::InputText("##name", &kept.name);
        widgets.note(fmt::format("compare.{}.name", k + 1));
        tooltip(tr("Name of this state"));
        ImGui::SameLine();
        if (ImGui::SmallButton(tr("Scale"))) wish.use_scale = kept.scale;
        widgets.note(fmt::format("compare.{}.scale", k + 1));
        tooltip(tr("Show all pictures with the colour scale that this state was kept with"));
        ImGui::SameLine();
        if (ImGui::SmallButton("×")) removed = k;
        widgets.note(fmt::format("compare.{}.remove", k + 1));
        tooltip(tr("Remove this state from the list"));
        ImGui::PopID();
    }
    if (removed) snapshots.remove(*removed);
}

void right_cell(const std::string& text) {
    ImGui::TableNextColumn();
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
    if (room > 0.0F) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room);
    ImGui::TextUnformatted(text.c_str());
}

std::string signed_figure(double lux) {
    if (lux == 0.0) return "0";
    return fmt::format("{}{}", lux < 0.0 ? "−" : "+", illuminance_figure(std::abs(lux)));
}

void grids_table(const Solution& first, const Solution& second, CompareWish& wish, WidgetRegistry& widgets) {
    const std::vector<GridDifference> rows = compared_grids(first, second);
    if (rows.empty()) {
        quiet_words(tr("No calculation grid to compare."));
        return;
    }
    if (!ImGui::BeginTable("compared", 6,
                           ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersInnerH |
                               ImGuiTableFlags_SizingStretchProp))
        return;
    const std::string unit = illuminance_unit_name();
    const std::string titles[] = {tr("Grid"),
                                  fmt::format("A  {}", unit),
                                  fmt::format("B  {}", unit),
                                  fmt::format("B − A  {}", unit),
                                  "B − A  %",
                                  tr("U0  A, B")};
    constexpr float shares[] = {2.0F, 0.9F, 0.9F, 1.1F, 0.9F, 1.7F};
    for (int k = 0; k < 6; ++k) ImGui::TableSetupColumn(titles[k].c_str(), 0, shares[k]);
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::PushStyleColor(ImGuiCol_Text, style::quiet_text);
    for (int k = 0; k < 6; ++k) {
        if (k > 0) {
            right_cell(titles[k]);
            continue;
        }
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(titles[k].c_str());
    }
    ImGui::PopStyleColor();
    for (const GridDifference& row : rows) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::PushID(static_cast<int>(row.grid.value));
        if (ImGui::Selectable("###row", false, ImGuiSelectableFlags_SpanAllColumns)) wish.chosen = row.grid;
        widgets.note("compared." + row.name);
        ImGui::SameLine(0.0F, 0.0F);
        elided_text(row.name.empty() ? "–" : row.name, 0.0F, Elide::middle);
        ImGui::PopID();
        const bool both = row.first && row.second;
        right_cell(row.first ? illuminance_figure(row.first->mean) : "–");
        right_cell(row.second ? illuminance_figure(row.second->mean) : "–");
        const double by = both ? row.second->mean - row.first->mean : 0.0;
        right_cell(both ? signed_figure(by) : "–");
        right_cell(both && row.first->mean > 0.0 ? fmt::format("{:+.1f}", 100.0 * by / row.first->mean) : "–");
        right_cell(both ? fmt::format("{:.2f}, {:.2f}", row.first->uniformity, row.second->uniformity) : "–");
    }
    ImGui::EndTable();
}

}  // namespace

CompareWish compare_panel(Snapshots& snapshots, const SolutionSnapshot& present, WidgetRegistry& widgets) {
    CompareWish wish;
    ImGui::BeginChild("kept", {list_width * style::scale(), 0.0F});
    wish.keep_a = ImGui::Button(tr("Keep as A"));
    widgets.note("compare.keep_a");
    tooltip(tr("Keep the light as it is now, to be compared as A  (Alt+A)"));
    ImGui::SameLine();
    wish.keep_b = ImGui::Button(tr("Keep as B"));
    widgets.note("compare.keep_b");
    tooltip(tr("Keep the light as it is now, to be compared as B  (Alt+B)"));
    if (snapshots.list().empty()) {
        ImGui::TextWrapped("%s", tr("Keep the light as A, change the room, and hold the key ` to flip between both."));
    } else {
        show_choices(snapshots, widgets);
        kept_list(snapshots, wish, widgets);
    }
    ImGui::EndChild();
    ImGui::SameLine(0.0F, 16.0F * style::scale());
    ImGui::BeginChild("compared grids", {0.0F, 0.0F});
    const SolutionSnapshot first = snapshots.first(), second = snapshots.second(present);
    if (first && second) grids_table(*first, *second, wish, widgets);
    ImGui::EndChild();
    return wish;
}

}  // namespace hanei
