#include "ui/panels/form.h"

#include "ui/panels/elided.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

namespace hanei {
namespace {

/// Before a name that is indented by six blanks.
void dot(ImDrawList* list, const ImVec2& corner, ImU32 colour) {
    const float radius = 4.0F * style::scale();
    const ImVec2 at{corner.x + 2.0F * radius, corner.y + 0.5F * ImGui::GetTextLineHeight()};
    list->AddCircleFilled(at, radius, colour);
    list->AddCircle(at, radius, style::border, 0, style::hairline());  // white is seen on white
}

}  // namespace

void tooltip(const char* text) {
    if (text == nullptr || *text == '\0' || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24.0F);
    ImGui::TextUnformatted(tr(text));
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void tooltip(const std::string& text) { tooltip(text.c_str()); }

void Form::begin(const char* id) {
    ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoPadOuterX);
    ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthFixed, 96.0F * style::scale());
    ImGui::TableSetupColumn("field", ImGuiTableColumnFlags_WidthStretch);
}

void Form::end() { ImGui::EndTable(); }

void Form::begin_frame() {
    finished_ = false;
    shared_.begin_frame();
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) || typing_ != 0) refused_ = {};
}

void Form::heading(const char* text) {
    if (!shared_.draws()) return;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::Dummy({0.0F, 2.0F * style::scale()});
    ImGui::PushFont(style::fonts().strong);
    ImGui::TextUnformatted(tr(text));
    ImGui::PopFont();
}

void Form::label(const char* text, const char* help) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    const std::string shown = elided(tr(text), ImGui::GetContentRegionAvail().x);
    ImGui::TextColored(style::colour(style::quiet_text), "%s", shown.c_str());
    if (help != nullptr && *help != '\0')
        tooltip(help);
    else if (shown != tr(text))
        tooltip(text);
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(-FLT_MIN);
}

void Form::unit(const char* text) {
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(style::colour(style::quiet_text), "%s", text);
}

/// For the item drawn last: true when its typed content is finished and differs from what was there.
bool Form::accept_typed(bool edited, bool typing) {
    const ImGuiID item = ImGui::GetItemID();
    if (typing && edited) typing_ = item;
    if (typing_ != item || typing) return false;
    typing_ = 0;
    return ImGui::IsItemDeactivatedAfterEdit() && !ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
}

bool Form::text(const char* name, const char* label_text, const char* help, std::string& value) {
    if (!shared_.draws()) return shared_.row(name, value);
    label(label_text, help);
    if (!typed(name, help, value, shared_.is_mixed(name, value))) return false;
    shared_.note_change(name, value);
    return true;
}

/// The field alone.
bool Form::typed(const char* name, const char* help, std::string& value, bool mixed) {
    style::needs(value);
    std::string shown = mixed ? std::string() : value;
    const bool edited = ImGui::InputTextWithHint((std::string("##") + name).c_str(), mixed ? tr("mixed") : "", &shown,
                                                 ImGuiInputTextFlags_AutoSelectAll);
    widgets_.note(name);
    tooltip(help);
    const bool typing = ImGui::IsItemActive();
    if (edited || typing) typed_text_ = shown;
    if (edited && !typing) typing_ = ImGui::GetItemID();  // changed and finished within one frame
    const bool accepted = accept_typed(edited, typing);
    if (!accepted || (typed_text_ == value && !mixed)) return false;
    value = typed_text_;
    finished_ = true;
    return true;
}

bool Form::toggle(const char* name, const char* label_text, const char* help, bool& value) {
    if (!shared_.draws()) return shared_.row(name, value);
    const bool mixed = shared_.is_mixed(name, value);
    label(label_text, help);
    if (mixed) ImGui::PushItemFlag(ImGuiItemFlags_MixedValue, true);
    const bool changed = ImGui::Checkbox((std::string("##") + name).c_str(), &value);
    if (mixed) ImGui::PopItemFlag();
    if (changed) shared_.note_change(name, value);
    widgets_.note(name);
    tooltip(help);
    finished_ |= changed;
    return changed;
}

bool Form::choice(const char* name, const char* label_text, const char* help, std::span<const std::string> names,
                  int& chosen, std::span<const ImU32> marks) {
    const bool valid = chosen >= 0 && chosen < static_cast<int>(names.size());
    std::string entry_now = valid ? names[static_cast<std::size_t>(chosen)] : std::string();
    if (!shared_.draws()) {
        if (!shared_.row(name, entry_now)) return false;
        const auto found = std::find(names.begin(), names.end(), entry_now);
        if (found == names.end()) return false;
        chosen = static_cast<int>(found - names.begin());
        return true;
    }
    const bool mixed = shared_.is_mixed(name, entry_now);
    label(label_text, help);
    ImDrawList* const field = ImGui::GetWindowDrawList();
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const char* const indent = marks.empty() ? "" : "      ";
    bool changed = false;
    for (const std::string& each : names) style::needs(each);
    const std::string preview =
        mixed ? std::string(tr("mixed")) : fmt::format("{}{}", indent, tr(std::string_view(entry_now)));
    const bool open = ImGui::BeginCombo((std::string("##") + name).c_str(), preview.c_str());
    if (valid && !mixed && !marks.empty())
        dot(field, {at.x + padding.x, at.y + padding.y}, marks[static_cast<std::size_t>(chosen)]);
    widgets_.note(name);
    if (!open) tooltip(help);
    if (open) {
        for (int k = 0; k < static_cast<int>(names.size()); ++k) {
            const std::string& entry = names[static_cast<std::size_t>(k)];
            const ImVec2 corner = ImGui::GetCursorScreenPos();
            if (ImGui::Selectable(fmt::format("{}{}##{}", indent, tr(std::string_view(entry)), k).c_str(),
                                  k == chosen && !mixed) &&
                (k != chosen || mixed)) {
                chosen = k;
                changed = true;
            }
            if (!marks.empty()) dot(ImGui::GetWindowDrawList(), corner, marks[static_cast<std::size_t>(k)]);
            widgets_.note(std::string(name) + "." + entry);
        }
        ImGui::EndCombo();
    }
    finished_ |= changed;
    if (changed) shared_.note_change(name, names[static_cast<std::size_t>(chosen)]);
    return changed;
}

void Form::fact(const char* label_text, const std::string& value, const char* unit_text) {
    if (!shared_.draws()) return;
    label(label_text, nullptr);
    ImGui::AlignTextToFramePadding();
    const float beside = *unit_text != '\0' ? ImGui::CalcTextSize(unit_text).x + ImGui::GetStyle().ItemSpacing.x : 0.0F;
    elided_text(value, std::max(1.0F, ImGui::GetContentRegionAvail().x - beside), Elide::middle);
    if (*unit_text != '\0') unit(unit_text);
}

bool Form::button(const char* name, const char* label_text, const char* help) {
    if (!shared_.draws()) return shared_.pressed(name);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TableNextColumn();
    const bool pressed = ImGui::Button(fmt::format("{}##{}", tr(label_text), name).c_str(), {-FLT_MIN, 0.0F});
    widgets_.note(name);
    tooltip(help);
    finished_ |= pressed;
    if (pressed) shared_.note_change(name, {});
    return pressed;
}

void Form::remark(const std::string& text, bool warning) {
    if (!shared_.draws()) return;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, warning ? style::warning : style::quiet_text);
    ImGui::TextWrapped("%s", tr(std::string_view(text)).data());
    ImGui::PopStyleColor();
}

}  // namespace hanei
