#include "ui/panels/messages_panel.h"

#include "engine/edit/edit.h"
#include "engine/scene/hard_spots.h"
#include "engine/scene/scene_check.h"
#include "ui/panels/elided.h"
#include "ui/panels/form.h"
#include "ui/panels/icon.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <ctime>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

namespace hanei {
namespace {

std::string time_text(std::chrono::system_clock::time_point when) {
    const std::time_t seconds = std::chrono::system_clock::to_time_t(when);
    std::tm local{};
    localtime_r(&seconds, &local);
    return fmt::format("{:%H:%M:%S}", local);
}

/// Beside its sign, so that nobody has to tell by colour alone.
const char* severity_text(Severity severity) {
    return severity == Severity::error ? tr("Error") : severity == Severity::warning ? tr("Warning") : tr("Note");
}

bool holds(const std::string& text, const std::string& words) {
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    return std::search(text.begin(), text.end(), words.begin(), words.end(), same) != text.end();
}

}  // namespace

const Diagnostics& MessagesPanel::checks_of(const SceneSnapshot& scene, const Diagnostics& findings) {
    if (!lists_hard_spots_) return findings;
    if (looked_at_ != scene) {
        spots_ = has_errors(check_scene(*scene)) ? Diagnostics{} : hard_spots(*scene);
        looked_at_ = scene;
    }
    checks_ = findings;
    checks_.insert(checks_.end(), spots_.begin(), spots_.end());
    checks_.insert(checks_.begin(), {Severity::note, {}, verdict_of(checks_)});
    return checks_;
}

std::vector<MessagesPanel::Row> MessagesPanel::rows(const Diagnostics& checks, const Messages& messages,
                                                    bool timed) const {
    std::vector<Row> rows;
    const auto add = [&](Row row) {
        if (static_cast<int>(row.finding.severity) < least_) return;
        if (words_.empty() || holds(row.source + ' ' + to_text(row.finding), words_)) rows.push_back(std::move(row));
    };
    for (const Diagnostic& finding : checks) add({tr("now"), tr("Scene"), finding, 1});
    const auto& entries = messages.entries();
    for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry)
        add({timed ? time_text(entry->when) : std::string(), entry->source, entry->finding, entry->count});
    return rows;
}

void MessagesPanel::tools(const std::vector<Row>& shown, Messages& messages, WidgetRegistry& widgets) {
    const std::array names{tr("All"), tr("Warnings and errors"), tr("Errors")};
    ImGui::SetNextItemWidth(170.0F * style::scale());
    ImGui::Combo("##least", &least_, names.data(), static_cast<int>(names.size()));
    widgets.note("messages.least");
    tooltip("How bad a message must be to be listed");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(170.0F * style::scale());
    ImGui::InputTextWithHint("##words", tr("Search"), &words_);
    widgets.note("messages.words");
    tooltip("Only messages that hold these words");
    ImGui::SameLine();
    if (ImGui::Button(tr("Copy"))) {
        std::string text;
        for (const Row& row : shown) text += fmt::format("{}\t{}\t{}\n", row.time, row.source, to_text(row.finding));
        ImGui::SetClipboardText(text.c_str());
    }
    widgets.note("messages.copy");
    tooltip("The listed messages as text to the clipboard");
    ImGui::SameLine();
    if (ImGui::Button(tr("Clear"))) {
        messages.clear();
        lists_hard_spots_ = false;
        looked_at_.reset();
    }
    widgets.note("messages.clear");
    tooltip("Forget what happened; what is wrong with the scene stays until it is mended");
}

std::optional<ObjectId> MessagesPanel::draw(const Scene& scene, const Diagnostics& checks, Messages& messages,
                                            bool timed, WidgetRegistry& widgets) {
    messages.mark_read();
    const std::vector<Row> shown = rows(checks, messages, timed);
    tools(shown, messages, widgets);
    std::optional<ObjectId> clicked;
    if (shown.empty()) {
        const bool none = checks.empty() && messages.entries().empty();
        ImGui::TextDisabled("%s",
                            none ? tr("Nothing is wrong, and nothing went wrong.") : tr("No message is of this kind."));
        return clicked;
    }
    constexpr int look = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersInnerH |
                         ImGuiTableFlags_SizingStretchProp;
    if (!ImGui::BeginTable("messages", 5, look)) return clicked;
    ImGui::TableSetupColumn("severity", 0, 1.1F);
    ImGui::TableSetupColumn("time", 0, 0.9F);
    ImGui::TableSetupColumn("source", 0, 1.0F);
    ImGui::TableSetupColumn("object", 0, 1.4F);
    ImGui::TableSetupColumn("message", 0, 6.0F);
    for (std::size_t k = 0; k < shown.size(); ++k) {
        const Diagnostic& finding = shown[k].finding;
        const ObjectId object{finding.place.object};
        const bool exists = kind_of(scene, object) != ObjectKind::none;
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        icon_item(icon_of(finding.severity), colour_of(finding.severity));
        ImGui::PushStyleColor(ImGuiCol_Text, colour_of(finding.severity));
        if (ImGui::Selectable(fmt::format("{}##{}", severity_text(finding.severity), k).c_str(), false,
                              ImGuiSelectableFlags_SpanAllColumns) &&
            exists)
            clicked = object;
        ImGui::PopStyleColor();
        widgets.note(fmt::format("message.{}", k + 1));
        if (exists) tooltip("Click to select the object");
        for (const std::string& text :
             {shown[k].time, shown[k].source, exists ? display_name(scene, object) : std::string()}) {
            ImGui::TableNextColumn();
            ImGui::PushStyleColor(ImGuiCol_Text, style::quiet_text);
            elided_text(text, 0.0F, Elide::middle);
            ImGui::PopStyleColor();
        }
        ImGui::TableNextColumn();
        Diagnostic plain = finding;
        plain.severity = Severity::error;  // written without a word: the sign says it
        std::string text = to_text(plain);
        if (shown[k].count > 1) text += say("  ({} times)", shown[k].count);
        ImGui::TextWrapped("%s", text.c_str());
    }
    ImGui::EndTable();
    return clicked;
}

}  // namespace hanei
