#include "ui/panels/dialogs.h"

#include "ui/panels/command.h"
#include "ui/panels/dialog_frame.h"
#include "ui/panels/icon.h"
#include "ui/panels/keyboard_map.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <imgui.h>
#include <optional>
#include <utility>

namespace hanei {
namespace {

bool key_pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false); }

}  // namespace

std::string_view name_of(Dialogs::Kind kind) {
    constexpr std::array names{"none", "unsaved", "findings", "choice", "keys", "about"};
    return names[static_cast<std::size_t>(kind)];
}

void Dialogs::show(Kind kind) {
    kind_ = kind;
    opening_ = true;
}

void Dialogs::close() {
    kind_ = Kind::none;
    ImGui::CloseCurrentPopup();
}

void Dialogs::ask_unsaved(std::string title, std::function<void()> save, std::function<void()> proceed) {
    title_ = std::move(title);
    save_ = std::move(save);
    proceed_ = std::move(proceed);
    show(Kind::unsaved);
}

void Dialogs::show_findings(std::string title, Diagnostics findings) {
    title_ = std::move(title);
    findings_ = std::move(findings);
    show(Kind::findings);
}

void Dialogs::ask_choice(std::string title, std::string text, std::vector<std::string> entries,
                         std::function<void(std::size_t)> chosen) {
    title_ = std::move(title);
    text_ = std::move(text);
    entries_ = std::move(entries);
    chosen_ = std::move(chosen);
    show(Kind::choice);
}

bool Dialogs::begin(const char* title, float width) {
    const std::string label = fmt::format("{}###dialog", tr(title));
    bool stays = false;
    const bool drawn = begin_dialog(label, width, opening_, stays);
    if (!drawn) kind_ = Kind::none;
    return drawn;
}

void Dialogs::unsaved(WidgetRegistry& widgets) {
    if (!begin("Unsaved changes", 460.0F)) return;
    ImGui::TextWrapped("%s", say("{} has changes that were not saved.", title_).c_str());
    buttons_from_right(3);
    std::function<void()> then;
    if (dialog_button("Don't save", "unsaved.discard", widgets)) then = proceed_;
    ImGui::SameLine();
    const bool cancel = dialog_button("Cancel", "unsaved.cancel", widgets) || key_pressed(ImGuiKey_Escape);
    ImGui::SameLine();
    if (dialog_button("Save", "unsaved.save", widgets) || key_pressed(ImGuiKey_Enter)) then = save_;
    if (cancel || then) close();
    ImGui::EndPopup();
    if (then) then();
}

void Dialogs::findings(WidgetRegistry& widgets) {
    if (!begin(title_.c_str(), 620.0F)) return;
    for (const Diagnostic& finding : findings_) {
        icon_item(icon_of(finding.severity), colour_of(finding.severity));
        ImGui::TextWrapped("%s", to_text(finding).c_str());
    }
    buttons_from_right(1);
    if (dialog_button("OK", "findings.ok", widgets) || key_pressed(ImGuiKey_Enter) || key_pressed(ImGuiKey_Escape))
        close();
    ImGui::EndPopup();
}

void Dialogs::choice(WidgetRegistry& widgets) {
    if (!begin(title_.c_str(), 480.0F)) return;
    ImGui::TextWrapped("%s", text_.c_str());
    constexpr std::size_t most_rows = 12;
    const auto rows = static_cast<float>(std::min(entries_.size(), most_rows));
    const float row = ImGui::GetTextLineHeightWithSpacing();
    ImGui::BeginChild("entries", {0.0F, rows * row + 8.0F * style::scale()});
    std::optional<std::size_t> picked;
    for (std::size_t k = 0; k < entries_.size(); ++k) {
        const std::string label = fmt::format("{}##{}", tr(std::string_view(entries_[k])), k);
        if (ImGui::Selectable(label.c_str(), false, ImGuiSelectableFlags_DontClosePopups)) picked = k;
        widgets.note("choice." + std::to_string(k + 1));
    }
    ImGui::EndChild();
    buttons_from_right(1);
    const bool cancel = dialog_button("Cancel", "choice.cancel", widgets) || key_pressed(ImGuiKey_Escape);
    if (cancel || picked) close();
    ImGui::EndPopup();
    if (picked) std::exchange(chosen_, nullptr)(*picked);
}

void Dialogs::keys(WidgetRegistry& widgets) {
    if (!begin("Keys and mouse", 960.0F)) return;
    const float frame = 2.0F * ImGui::GetStyle().WindowPadding.y + 4.0F * ImGui::GetFrameHeightWithSpacing();
    draw_keyboard_map(ImGui::GetIO().DisplaySize.y - 60.0F - frame, widgets);
    buttons_from_right(1);
    if (dialog_button("Close", "keys.close", widgets) || key_pressed(ImGuiKey_Escape)) close();
    ImGui::EndPopup();
}

void Dialogs::about(WidgetRegistry& widgets) {
    if (!begin("About Hanei", 480.0F)) return;
    ImGui::PushFont(style::fonts().strong);
    ImGui::TextUnformatted("Hanei");
    ImGui::PopFont();
    ImGui::TextWrapped("%s",
                       tr("Lighting design with exact direct light, interreflection, and an error bar on every value. "
                          "All surfaces are taken as perfectly diffuse: there are no mirrors and no gloss."));
    ImGui::TextWrapped("%s", tr("Licence: Apache-2.0."));
    buttons_from_right(1);
    if (dialog_button("Close", "about.close", widgets) || key_pressed(ImGuiKey_Escape)) close();
    ImGui::EndPopup();
}

void Dialogs::draw(WidgetRegistry& widgets) {
    switch (kind_) {
        case Kind::none:
            return;
        case Kind::unsaved:
            return unsaved(widgets);
        case Kind::findings:
            return findings(widgets);
        case Kind::choice:
            return choice(widgets);
        case Kind::keys:
            return keys(widgets);
        case Kind::about:
            return about(widgets);
    }
}

}  // namespace hanei
