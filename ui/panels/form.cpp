#include "ui/panels/form.h"

#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

namespace hanei {
namespace {

constexpr float unit_width = 46.0F;  // of "cd/m²", the longest, and a gap

/// Before a name that is indented by six blanks.
void dot(ImDrawList* list, const ImVec2& corner, ImU32 colour) {
    const float radius = 4.0F * style::scale();
    list->AddCircleFilled({corner.x + 2.0F * radius, corner.y + 0.5F * ImGui::GetTextLineHeight()}, radius, colour);
}

std::string printf_format(int decimals) { return fmt::format("%.{}f", decimals); }

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

void Form::heading(const char* text) {
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
    ImGui::TextColored(style::colour(style::quiet_text), "%s", tr(text));
    tooltip(help);
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

bool Form::number(const NumberField& field, double& value) {
    label(field.label, field.help);
    ImGui::SetNextItemWidth(-unit_width * style::scale());  // units stand in a column of their own
    double shown = value;
    const std::string hidden = std::string("##") + field.name;
    bool edited = ImGui::DragScalar(hidden.c_str(), ImGuiDataType_Double, &shown, static_cast<float>(field.step),
                                    &field.low, &field.high, printf_format(field.decimals).c_str());
    widgets_.note(field.name);
    tooltip(field.help);
    const ImGuiID item = ImGui::GetItemID();
    const bool typing = ImGui::TempInputIsActive(item);
    if (typing) typed_number_ = shown;
    const bool was_typed = typing_ == item;
    const bool accepted = accept_typed(edited, typing);
    if (accepted && !edited) shown = typed_number_;
    if (accepted) finished_ = true;
    if ((typing || was_typed) && !accepted) edited = false;
    unit(field.unit);
    if (!(edited || accepted) || !std::isfinite(shown)) return false;
    shown = std::clamp(shown, field.low, field.high);
    if (shown == value) return false;
    value = shown;
    return true;
}

bool Form::text(const char* name, const char* label_text, const char* help, std::string& value) {
    label(label_text, help);
    return typed(name, help, value);
}

/// The field alone.
bool Form::typed(const char* name, const char* help, std::string& value) {
    std::string shown = value;
    const bool edited = ImGui::InputText((std::string("##") + name).c_str(), &shown, ImGuiInputTextFlags_AutoSelectAll);
    widgets_.note(name);
    tooltip(help);
    const bool typing = ImGui::IsItemActive();
    if (edited || typing) typed_text_ = shown;
    if (edited && !typing) typing_ = ImGui::GetItemID();  // changed and finished within one frame
    const bool accepted = accept_typed(edited, typing);
    if (!accepted || typed_text_ == value) return false;
    value = typed_text_;
    finished_ = true;
    return true;
}

bool Form::toggle(const char* name, const char* label_text, const char* help, bool& value) {
    label(label_text, help);
    const bool changed = ImGui::Checkbox((std::string("##") + name).c_str(), &value);
    widgets_.note(name);
    tooltip(help);
    finished_ |= changed;
    return changed;
}

bool Form::choice(const char* name, const char* label_text, const char* help, std::span<const std::string> names,
                  int& chosen, std::span<const ImU32> marks) {
    label(label_text, help);
    ImDrawList* const field = ImGui::GetWindowDrawList();
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const char* const indent = marks.empty() ? "" : "      ";
    bool changed = false;
    const bool valid = chosen >= 0 && chosen < static_cast<int>(names.size());
    const std::string preview = valid ? indent + names[static_cast<std::size_t>(chosen)] : std::string();
    const bool open = ImGui::BeginCombo((std::string("##") + name).c_str(), preview.c_str());
    if (valid && !marks.empty())
        dot(field, {at.x + padding.x, at.y + padding.y}, marks[static_cast<std::size_t>(chosen)]);
    widgets_.note(name);
    if (!open) tooltip(help);
    if (open) {
        for (int k = 0; k < static_cast<int>(names.size()); ++k) {
            const std::string& entry = names[static_cast<std::size_t>(k)];
            const ImVec2 corner = ImGui::GetCursorScreenPos();
            if (ImGui::Selectable((indent + entry + "##" + std::to_string(k)).c_str(), k == chosen) && k != chosen) {
                chosen = k;
                changed = true;
            }
            if (!marks.empty()) dot(ImGui::GetWindowDrawList(), corner, marks[static_cast<std::size_t>(k)]);
            widgets_.note(std::string(name) + "." + entry);
        }
        ImGui::EndCombo();
    }
    finished_ |= changed;
    return changed;
}

void Form::fact(const char* label_text, const std::string& value, const char* unit_text) {
    label(label_text, nullptr);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(value.c_str());
    if (ImGui::GetItemRectSize().x > ImGui::GetColumnWidth()) tooltip(value);
    if (*unit_text != '\0') unit(unit_text);
}

bool Form::button(const char* name, const char* label_text, const char* help) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TableNextColumn();
    const bool pressed = ImGui::Button(fmt::format("{}##{}", tr(label_text), name).c_str(), {-FLT_MIN, 0.0F});
    widgets_.note(name);
    tooltip(help);
    finished_ |= pressed;
    return pressed;
}

void Form::remark(const std::string& text, bool warning) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, warning ? style::warning : style::quiet_text);
    ImGui::TextWrapped("%s", tr(std::string_view(text)).data());
    ImGui::PopStyleColor();
}

}  // namespace hanei
