#include "ui/panels/command_search.h"

#include "ui/panels/form.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <sstream>

namespace hanei {
namespace {

constexpr int most_rows = 12;

std::string small(std::string_view text) {
    std::string lower(text);
    for (char& letter : lower) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return lower;
}

/// 0 best; negative: it does not match.
int rank_of(const Command& entry, const std::string& text) {
    const std::string label = small(entry.label) + ' ' + small(tr(entry.label));
    const std::string all = label + ' ' + small(entry.menu) + ' ' + small(entry.help) + ' ' + small(entry.name);
    std::istringstream words(text);
    for (std::string word; words >> word;)
        if (all.find(word) == std::string::npos) return -1;
    const std::size_t at = label.find(text);
    return at == 0 ? 0 : at != std::string::npos ? 1 : 2;
}

/// Why it cannot be done as things are: what commands of its menu wait for.
const char* reason_of(const Command& entry) {
    if (entry.menu == "Arrange" || entry.menu == "Edit") return "Not now: select what it is meant for first.";
    if (entry.menu == "Light") return "Not now: select luminaires first.";
    if (entry.menu == "Results") return "Not now: it needs computed values, or what they are read at.";
    return "Not now: there is nothing that it could be done to.";
}

void note_of_impossible() {
    ImGui::Separator();
    ImGui::TextColored(style::colour(style::quiet_text), "%s", tr("Not possible as things are:"));
}

bool is_pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); }

}  // namespace

std::vector<const Command*> commands_matching(std::string_view text) {
    const std::string wanted = small(text);
    std::vector<std::pair<int, const Command*>> ranked;
    for (const Command& entry : commands()) {
        const int rank = rank_of(entry, wanted);
        if (rank >= 0) ranked.emplace_back(rank, &entry);
    }
    std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<const Command*> found;
    for (const auto& [rank, entry] : ranked) found.push_back(entry);
    return found;
}

std::optional<CommandId> CommandSearch::draw(const std::function<bool(CommandId)>& can, WidgetRegistry& widgets) {
    const float scale = style::scale();
    if (opening_) {
        ImGui::OpenPopup("###commands");
        text_.clear();
        row_ = 0;
    }
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * screen.x, 90.0F * scale}, ImGuiCond_Always, {0.5F, 0.0F});
    ImGui::SetNextWindowSize({std::min(560.0F * scale, screen.x - 40.0F), 0.0F});
    open_ = ImGui::BeginPopup("###commands");
    if (!open_) return opening_ = false, std::nullopt;
    if (opening_) ImGui::SetKeyboardFocusHere();
    opening_ = false;
    ImGui::SetNextItemWidth(-FLT_MIN);
    if (ImGui::InputTextWithHint("##text", tr("What do you want to do?"), &text_)) row_ = 0;
    widgets.note("search.text");
    tooltip("Words of a command: its name, its menu or what it does. Enter carries it out");
    std::vector<const Command*> found = commands_matching(text_);
    const auto impossible =
        std::stable_partition(found.begin(), found.end(), [&](const Command* entry) { return can(entry->id); });
    const int possible_rows = static_cast<int>(impossible - found.begin());
    const int count = static_cast<int>(found.size());
    if (is_pressed(ImGuiKey_DownArrow)) row_ = std::min(row_ + 1, count - 1);
    if (is_pressed(ImGuiKey_UpArrow)) row_ = std::max(row_ - 1, 0);
    std::optional<CommandId> wished;
    ImGui::BeginChild("rows", {0.0F, static_cast<float>(most_rows) * ImGui::GetTextLineHeightWithSpacing()});
    for (int k = 0; k < count; ++k) {
        const Command& entry = *found[static_cast<std::size_t>(k)];
        const bool possible = k < possible_rows;
        if (k == possible_rows) note_of_impossible();
        ImGui::PushStyleColor(ImGuiCol_Text, possible ? style::text : style::quiet_text);
        const std::string label = fmt::format("{}##{}", tr(entry.label), entry.name);
        if (ImGui::Selectable(label.c_str(), k == row_) && possible) wished = entry.id;
        ImGui::PopStyleColor();
        widgets.note("search." + std::string(entry.name));
        tooltip(possible ? std::string(tr(entry.help)) : fmt::format("{}\n{}", tr(entry.help), tr(reason_of(entry))));
        if (k == row_ && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
        const std::string keys = fmt::format("{}   {}", tr(entry.menu), to_text(entry.chord));
        ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(keys.c_str()).x - 6.0F * scale);
        ImGui::TextColored(style::colour(style::quiet_text), "%s", keys.c_str());
    }
    if (count == 0) ImGui::TextColored(style::colour(style::quiet_text), "%s", tr("No command is called so."));
    ImGui::EndChild();
    const bool entered = is_pressed(ImGuiKey_Enter) && row_ < count;
    if (entered && row_ < possible_rows) wished = found[static_cast<std::size_t>(row_)]->id;
    if (wished || is_pressed(ImGuiKey_Escape)) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return wished;
}

}  // namespace hanei
