#include "ui/panels/measured_dialog.h"

#include "ui/panels/dialog_frame.h"
#include "ui/panels/form.h"
#include "ui/panels/illuminance_text.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>
#include <numeric>
#include <span>

namespace hanei {
namespace {

struct Column {
    const char* name;
    const char* help;
    float width;  ///< at scale 1; 0: what the others leave
};

constexpr Column set_columns[] = {{"Set", "", 0.0F},
                                  {"Points", "", 60.0F},
                                  {"Theirs", "Mean", 76.0F},
                                  {"Ours", "Mean", 76.0F},
                                  {"Off, mean", "Deviation without its sign", 130.0F},
                                  {"95 %", "95 of 100 values are no further off", 130.0F},
                                  {"Largest", "", 130.0F},
                                  {"In our error", "No further apart than our error bar", 100.0F},
                                  {"In theirs", "No further apart than their uncertainty", 100.0F}};
constexpr Column pair_columns[] = {{"Set", "", 0.0F},
                                   {"Place", "x, y, z in metres", 170.0F},
                                   {"Theirs", "", 130.0F},
                                   {"Ours", "With our error bar", 130.0F},
                                   {"Ours − theirs", "", 150.0F}};

bool begin_table(const char* id, std::span<const Column> columns, float height) {
    constexpr ImGuiTableFlags flags =
        ImGuiTableFlags_ScrollY | ImGuiTableFlags_ScrollX | ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit;
    float needed = 160.0F;
    for (const Column& column : columns) needed += column.width + 8.0F;
    needed *= style::scale();
    const bool scrolls = needed > ImGui::GetContentRegionAvail().x;
    if (!ImGui::BeginTable(id, static_cast<int>(columns.size()), flags, {0.0F, height}, scrolls ? needed : 0.0F))
        return false;
    ImGui::TableSetupScrollFreeze(0, 1);
    for (const Column& column : columns)
        ImGui::TableSetupColumn(
            column.name, column.width > 0.0F ? ImGuiTableColumnFlags_WidthFixed : ImGuiTableColumnFlags_WidthStretch,
            column.width > 0.0F ? column.width * style::scale() : 1.0F);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (const Column& column : columns) {
        ImGui::TableNextColumn();
        ImGui::TextColored(style::colour(style::quiet_text), "%s", tr(column.name));
        if (*column.help != '\0') tooltip(tr(column.help));
    }
    return true;
}

void cell(const std::string& text) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text.c_str());
}

std::string off(double lux, double share) {
    return fmt::format("{} · {:.1f} %", illuminance_figure(lux), 100.0 * share);
}

std::string part(std::size_t count, std::size_t of) { return of > 0 ? say("{} of {}", count, of) : std::string("–"); }

float rows_high(std::size_t rows) { return (static_cast<float>(rows) + 1.5F) * ImGui::GetTextLineHeightWithSpacing(); }

}  // namespace

void MeasuredDialog::open(std::shared_ptr<const MeasuredComparison> comparison) {
    comparison_ = std::move(comparison);
    order_.resize(comparison_->pairs.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
        return std::abs(comparison_->pairs[a].difference()) > std::abs(comparison_->pairs[b].difference());
    });
    open_ = opening_ = true;
}

void MeasuredDialog::sets() const {
    const float screen = ImGui::GetIO().DisplaySize.y;
    if (!begin_table("sets", set_columns, std::min(rows_high(comparison_->sets.size()) + 8.0F, 0.25F * screen))) return;
    for (const MeasuredSet& set : comparison_->sets) {
        ImGui::TableNextRow();
        cell(set.name == "all" ? tr("All") : set.name);
        cell(std::to_string(set.points));
        cell(illuminance_figure(set.theirs));
        cell(illuminance_figure(set.ours));
        cell(off(set.lux.mean, set.share.mean));
        cell(off(set.lux.p95, set.share.p95));
        cell(off(set.lux.max, set.share.max));
        tooltip(largest_text(*comparison_, set));
        cell(part(set.within_ours, set.points));
        cell(part(set.within_theirs, set.with_theirs));
    }
    ImGui::EndTable();
}

void MeasuredDialog::pairs() const {
    const float screen = ImGui::GetIO().DisplaySize.y;
    if (!begin_table("pairs", pair_columns, std::min(rows_high(order_.size()) + 8.0F, 0.38F * screen))) return;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(order_.size()));
    while (clipper.Step()) {
        for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
            const MeasuredPair& pair = comparison_->pairs[order_[static_cast<std::size_t>(k)]];
            ImGui::TableNextRow();
            const std::string& set = comparison_->sets[pair.set].name;
            cell(pair.theirs.index ? fmt::format("{} · {}", set, *pair.theirs.index) : set);
            tooltip(say("Line {} of the file", pair.theirs.line));
            cell(fmt::format("{:.2f}, {:.2f}, {:.2f}", pair.position.x, pair.position.y, pair.position.z));
            cell(illuminance_figure(pair.theirs.lux) +
                 (pair.theirs.uncertainty ? " ± " + illuminance_figure(*pair.theirs.uncertainty) : std::string()));
            cell(illuminance_figure(pair.ours) + " ± " + illuminance_figure(pair.error_bar));
            const double by = pair.difference();
            const bool told = std::abs(by) > pair.error_bar + pair.theirs.uncertainty.value_or(0.0);
            const double share = pair.theirs.lux > 0.0 ? 100.0 * by / pair.theirs.lux : 0.0;
            ImGui::TableNextColumn();
            ImGui::TextColored(style::colour(told ? style::warning : style::text), "%s%s · %+.1f %%",
                               by < 0.0 ? "−" : "+", illuminance_figure(std::abs(by)).c_str(), share);
            if (told) tooltip(tr("Further apart than both error bars together"));
        }
    }
    ImGui::EndTable();
}

void MeasuredDialog::draw(WidgetRegistry& widgets) {
    if (!open_) return;
    const std::string label = fmt::format("{}###measured", tr("Compared with measured values"));
    bool stays = true;
    if (!begin_dialog(label, 1060.0F, opening_, stays)) {
        open_ = false;
        return;
    }
    const MeasuredComparison& made = *comparison_;
    const std::string name = std::filesystem::path(made.file).filename().string();
    std::string words = say("{}: {} values, {}", name, made.pairs.size(), illuminance_unit_name());
    if (made.without_value > 0) words += say(" · {} rows without a value", made.without_value);
    if (made.inside > 0) words += say(" · {} inside solids are left out", made.inside);
    ImGui::TextUnformatted(words.c_str());
    sets();
    widgets.note("measured.sets");
    ImGui::Dummy({0.0F, 4.0F * style::scale()});
    pairs();
    widgets.note("measured.pairs");
    buttons_from_right(3);
    if (dialog_button("Copy text", "measured.copy", widgets)) ImGui::SetClipboardText(measured_text(made).c_str());
    tooltip(tr("The sets, as text for a report"));
    ImGui::SameLine();
    if (dialog_button("Copy CSV", "measured.csv", widgets)) ImGui::SetClipboardText(measured_csv(made).c_str());
    tooltip(tr("Every value for a spreadsheet"));
    ImGui::SameLine();
    if (dialog_button("Close", "measured.close", widgets) || escape_pressed() || !stays) {
        open_ = false;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace hanei
