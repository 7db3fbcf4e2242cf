#include "ui/panels/results_panel.h"

#include "engine/edit/edit.h"
#include "ui/panels/elided.h"
#include "ui/panels/form.h"
#include "ui/panels/illuminance_text.h"
#include "ui/panels/language.h"
#include "ui/panels/live_study.h"
#include "ui/panels/probe.h"
#include "ui/panels/style.h"
#include "ui/panels/table_cells.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

bool name_cell(const std::string& name, ObjectId id, ObjectId selected, WidgetRegistry& widgets) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(id.value));
    const bool clicked = ImGui::Selectable("###row", id == selected, ImGuiSelectableFlags_SpanAllColumns);
    widgets.note("results." + name);
    ImGui::SameLine(0.0F, 0.0F);
    elided_text(name, 0.0F, Elide::middle);
    ImGui::PopID();
    return clicked;
}

void fact(const char* what, const std::string& value, const char* unit, const char* help) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextColored(style::colour(style::quiet_text), "%s", tr(what));
    tooltip(help);
    cell(value);
    cell(tr(unit), style::quiet_text);
}

}  // namespace

std::optional<ObjectId> results_table(const Solution& solution, ObjectId selected, WidgetRegistry& widgets) {
    std::optional<ObjectId> clicked;
    constexpr Column columns[] = {
        {"Grid or point", 2.2F, "Where illuminance is reported"},
        {"Mean  lx", 1.0F, "Mean illuminance of the grid, or the point's", true},
        {"Min  lx", 1.0F, "Least of the grid", true},
        {"Max  lx", 1.0F, "Greatest of the grid", true},
        {"U0", 0.7F, "Uniformity: least over mean (EN 12464-1)", true},
        {"Direct  lx", 1.0F, "Straight from luminaires", true},
        {"Error  ± lx", 1.0F, "How wrong a value may be: iteration, mesh, skipped effects and sampling", true},
    };
    if (!ImGui::BeginTable("results", 7, table_look)) return clicked;
    header(columns);
    for (const GridResult& grid : solution.grids) {
        const GridFigures figures = figures_of(grid);
        if (name_cell(display_name(*solution.scene, grid.grid), grid.grid, selected, widgets)) clicked = grid.grid;
        double direct = 0.0;
        for (const PointResult& point : grid.points) direct += point.value.direct.value;
        figure(illuminance_figure(figures.mean));
        figure(illuminance_figure(figures.min));
        figure(illuminance_figure(figures.max));
        figure(fmt::format("{:.2f}", figures.uniformity));
        figure(figures.points > 0 ? illuminance_figure(direct / figures.points) : "–");
        figure(illuminance_figure(figures.largest_error));
    }
    for (const PointResult& point : solution.points) {
        if (name_cell(display_name(*solution.scene, point.point), point.point, selected, widgets))
            clicked = point.point;
        figure(point.value.inside_solid ? tr("inside") : illuminance_figure(point.value.total().value));
        for (int k = 0; k < 3; ++k) figure("");
        figure(illuminance_figure(point.value.direct.value));
        figure(illuminance_figure(point.value.error.total()));
    }
    ImGui::EndTable();
    return clicked;
}

void energy_table(const Solution& solution, bool measured) {
    if (!solution.refusal.empty()) ImGui::TextWrapped("%s", solution.refusal.c_str());
    for (const std::string& note : solution.notes) ImGui::TextWrapped("%s", note.c_str());
    if (!ImGui::BeginTable("energy", 3, ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit)) return;
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthFixed, 220.0F * style::scale());
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed, 110.0F * style::scale());
    ImGui::TableSetupColumn("unit", ImGuiTableColumnFlags_WidthFixed, 60.0F * style::scale());
    const EnergyBalance& energy = solution.energy;
    fact("Emitted", short_figure(energy.emitted), "lm", "By luminaires and surfaces that shine by themselves");
    fact("Absorbed by surfaces", short_figure(energy.absorbed), "lm", "");
    if (energy.on_luminaires > 0.0)
        fact("Absorbed by luminaires", short_figure(energy.on_luminaires), "lm", "Straight from other luminaires");
    fact("Escaped", short_figure(energy.escaped), "lm",
         "Reflected to where no surface is seen: openings, backs of surfaces, opaque luminaires");
    fact("Unaccounted", fmt::format("{:.2g}", energy.imbalance()), "lm", "What patches and rounding leave over");
    fact("Patches", solution.mesh ? std::to_string(solution.mesh->patches.size()) : "–", "", "");
    fact("Interreflections", std::to_string(solution.bounces), "", "Bounces until the accuracy was reached");
    fact("Iteration error at most", illuminance_figure(solution.iteration_bound), illuminance_unit_name(),
         "A bound, at any patch");
    for (const StageTime& stage : solution.times) {
        if (!measured) break;
        fact(std::string(name_of(stage.stage)).c_str(), fmt::format("{:.1f}", stage.ms),
             stage.reused ? "ms, reused" : "ms", "");
    }
    ImGui::EndTable();
}

}  // namespace hanei
