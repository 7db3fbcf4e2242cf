#include "ui/panels/results_panel.h"

#include "engine/edit/edit.h"
#include "ui/panels/elided.h"
#include "ui/panels/form.h"
#include "ui/panels/icon.h"
#include "ui/panels/illuminance_text.h"
#include "ui/panels/language.h"
#include "ui/panels/live_study.h"
#include "ui/panels/probe.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

constexpr int table_look =
    ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp;

struct Column {
    const char* title;
    float share;
    const char* help;
    bool figures = false;  ///< right-aligned
};

void to_right(const char* text) {
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text).x;
    if (room > 0.0F) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room);
}

/// A title that ends in the unit ends in the one that is shown.
std::string in_shown_unit(const char* title) {
    std::string shown = tr(title);
    if (shown.ends_with("lx")) shown.replace(shown.size() - 2, 2, illuminance_unit_name());
    return shown;
}

void header(std::span<const Column> columns) {
    for (const Column& column : columns) {
        ImGui::TableSetupColumn(column.title, ImGuiTableColumnFlags_WidthStretch, column.share);
    }
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (int k = 0; k < static_cast<int>(columns.size()); ++k) {
        const Column& column = columns[static_cast<std::size_t>(k)];
        const char* const title = tr(column.title);
        ImGui::TableSetColumnIndex(k);
        ImGui::PushStyleColor(ImGuiCol_Text, style::quiet_text);
        const std::string shown = in_shown_unit(title);
        if (column.figures) to_right(shown.c_str());
        ImGui::TextUnformatted(shown.c_str());
        ImGui::PopStyleColor();
        tooltip(column.help);
    }
}

void cell(const std::string& text, ImU32 colour = style::text) {
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    elided_text(text);
    ImGui::PopStyleColor();
}

void figure(const std::string& text) {
    ImGui::TableNextColumn();
    to_right(text.c_str());
    ImGui::TextUnformatted(text.c_str());
}

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

/// Its mark tells the state by shape, its word in letters, its colour besides.
void state_cell(EffectState state) {
    const bool simulated = state == EffectState::simulated, skipped = state == EffectState::skipped;
    const ImU32 ink = simulated ? style::good : skipped ? style::warning : style::quiet_text;
    ImGui::TableNextColumn();
    icon_item(simulated ? Icon::done : skipped ? Icon::hidden : Icon::none, ink);
    ImGui::TextColored(style::colour(ink), "%s", std::string(tr(name_of(state))).c_str());
}

std::string milliseconds(double value) { return value < 0.0 ? "–" : short_figure(value) + " ms"; }

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

namespace {

std::string bound_figure(double lux) {
    return lux < 0.0 ? std::string("–") : std::isfinite(lux) ? illuminance_figure(lux) : std::string(tr("none"));
}

/// Where among the calculation points most is left out.
void tell_where(const PlannedEffect& row) {
    if (row.bound_at_points.empty() || !ImGui::IsItemHovered()) return;
    const auto most = std::max_element(row.bound_at_points.begin(), row.bound_at_points.end());
    double sum = 0.0;
    for (const double lux : row.bound_at_points) sum += lux;
    ImGui::SetTooltip(
        "%s", say("Most at calculation point {}: {} {}; {} in the mean",
                  std::to_string(most - row.bound_at_points.begin() + 1), illuminance_figure(*most),
                  illuminance_unit_name(), illuminance_figure(sum / static_cast<double>(row.bound_at_points.size())))
                  .c_str());
}

/// Who decides: the plan, or the user.
void choice_cell(Effect effect, Settings& settings, WidgetRegistry& widgets) {
    ImGui::TableNextColumn();
    const EffectOption* const option = option_of(effect);
    if (option == nullptr) return;
    constexpr const char* names[] = {"By its bound", "Always", "Never"};
    EffectChoice& choice = settings.*option->member;
    const std::string widget = "effects." + std::string(option->name);
    ImGui::SetNextItemWidth(-1.0F);
    if (ImGui::BeginCombo(("###" + widget).c_str(), tr(names[static_cast<std::size_t>(choice)]))) {
        for (const EffectChoice each : effect_choices) {
            const char* const name = names[static_cast<std::size_t>(each)];
            if (ImGui::Selectable(tr(name), each == choice)) choice = each;
            widgets.note(widget + "." + std::string(name_of(each)));
        }
        ImGui::EndCombo();
    } else {
        tooltip(
            "By its bound: skipped while all that is skipped adds no more than the tolerance (Calculation). "
            "Never: skipped however much it may add, and that is in every error bar");
    }
    widgets.note(widget);
}

/// Pieces of furniture, the dimmest first.
std::optional<ObjectId> piece_rows(const PlannedEffect& row, bool measured, WidgetRegistry& widgets) {
    std::optional<ObjectId> clicked;
    std::vector<const PlannedPiece*> pieces;
    for (const PlannedPiece& piece : row.pieces) pieces.push_back(&piece);
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const PlannedPiece* a, const PlannedPiece* b) { return a->bound_lux < b->bound_lux; });
    for (const PlannedPiece* piece : pieces) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::PushID(static_cast<int>(piece->object.value));
        ImGui::Indent();
        if (ImGui::Selectable("###piece", false)) clicked = piece->object;
        widgets.note("effects.piece." + piece->name);
        ImGui::SameLine(0.0F, 0.0F);
        elided_text(piece->name, 0.0F, Elide::middle);
        ImGui::Unindent();
        ImGui::PopID();
        state_cell(piece->state);
        cell(bound_figure(piece->bound_lux));
        cell(measured ? "≈ " + milliseconds(piece->predicted_ms) : "–");
        ImGui::TableNextColumn();
        cell(say("Reflectance {} on {} m²: what the paper decides by", short_figure(piece->reflectance),
                 short_figure(piece->area)),
             style::quiet_text);
    }
    return clicked;
}

}  // namespace

EffectsWish effects_table(const EffectsPlan& plan, const Settings& settings, bool measured, WidgetRegistry& widgets) {
    constexpr Column columns[] = {
        {"Effect", 2.0F, "What light does that may be simulated"},
        {"State", 1.1F, "Skipped effects are bounded, and counted in every error bar"},
        {"Bound  lx", 1.0F, "What skipping leaves out, or would, at any calculation point at most"},
        {"Cost", 0.9F, "Predicted, or measured once it ran"},
        {"Choice", 1.2F, "Who decides: the plan by its bounds, or you"},
        {"Why", 5.0F, ""},
    };
    EffectsWish wish;
    if (!ImGui::BeginTable("effects", 6, table_look)) return wish;
    header(columns);
    Settings wished = settings;
    for (const PlannedEffect& row : plan.effects) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        bool open = false;
        if (row.pieces.empty()) {
            elided_text(std::string(tr(name_of(row.effect))));
        } else {
            open =
                ImGui::TreeNodeEx("###pieces", ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanAvailWidth,
                                  "%s", std::string(tr(name_of(row.effect))).c_str());
            widgets.note("effects.pieces");
        }
        state_cell(row.state);
        cell(row.may_be_skipped || row.bound_lux > 0.0 ? bound_figure(row.bound_lux) : "–");
        tell_where(row);
        const bool ran = row.measured_ms >= 0.0;
        cell(!measured ? "–" : ran ? milliseconds(row.measured_ms) : "≈ " + milliseconds(row.predicted_ms));
        choice_cell(row.effect, wished, widgets);
        ImGui::TableNextColumn();
        ImGui::TextWrapped("%s", row.why.c_str());
        if (open)
            if (const auto clicked = piece_rows(row, measured, widgets)) wish.clicked = clicked;
    }
    ImGui::EndTable();
    if (wished != settings) wish.settings = wished;
    return wish;
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
