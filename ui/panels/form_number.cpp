#include "ui/panels/form.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"
#include "ui/panels/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <imgui_internal.h>

namespace hanei {
namespace {

constexpr float unit_width = 46.0F;  // of "cd/m²", the longest, and a gap

/// What became of a field of figures in this frame.
struct Touched {
    bool slid = false;    ///< dragged to another figure
    bool typing = false;  ///< its text is being typed
    std::string typed{};  ///< the text as it is
};

/// Takes hold of the field by mouse, Tab or keys; true when it is typed into from here on.
bool wants_typing(const ImRect& frame, ImGuiID id, bool by_tab) {
    ImGuiContext& context = *ImGui::GetCurrentContext();
    const bool hovered = ImGui::ItemHoverable(frame, id);
    const bool clicked = hovered && context.IO.MouseClicked[0];
    const bool twice = hovered && context.IO.MouseClickedCount[0] == 2;
    bool typing = false;
    if (by_tab || clicked || context.NavActivateId == id || context.NavActivateInputId == id) {
        ImGuiWindow* const window = ImGui::GetCurrentWindow();
        ImGui::SetActiveID(id, window);
        ImGui::SetFocusID(id, window);
        ImGui::FocusWindow(window);
        typing = by_tab || twice || (clicked && context.IO.KeyCtrl) || context.NavActivateInputId == id;
    }
    const bool let_go = context.ActiveId == id && hovered && context.IO.MouseReleased[0];
    if (!typing && let_go && !ImGui::IsMouseDragPastThreshold(0, 0.5F * context.IO.MouseDragThreshold)) {
        context.NavActivateId = context.NavActivateInputId = id;
        context.NavActivateFlags = ImGuiActivateFlags_PreferInput;
        typing = true;
    }
    return typing;
}

/// As ImGui's DragScalar, but what is typed is a text of our own reading: "2*0.6", "5'-3 1/2\"".
Touched figure_field(const char* label, double& shown, float step, double low, double high, int decimals,
                     const std::string& text, bool quiet) {
    Touched touched;
    ImGuiWindow* const window = ImGui::GetCurrentWindow();
    if (window->SkipItems) return touched;
    const ImGuiStyle& look = ImGui::GetStyle();
    const ImGuiID id = window->GetID(label);
    const ImVec2 corner = window->DC.CursorPos;
    const ImRect frame(corner, {corner.x + ImGui::CalcItemWidth(), corner.y + ImGui::GetFrameHeight()});
    ImGui::ItemSize(frame, look.FramePadding.y);
    if (!ImGui::ItemAdd(frame, id, &frame, ImGuiItemFlags_Inputable)) return touched;
    const bool by_tab =
        (ImGui::GetCurrentContext()->LastItemData.StatusFlags & ImGuiItemStatusFlags_FocusedByTabbing) != 0;
    if (ImGui::TempInputIsActive(id) || wants_typing(frame, id, by_tab)) {
        std::array<char, 256> letters{};
        text.copy(letters.data(), letters.size() - 1);
        constexpr int how = int{ImGuiInputTextFlags_AutoSelectAll} | int{ImGuiInputTextFlags_NoMarkEdited};
        if (ImGui::TempInputText(frame, id, label, letters.data(), static_cast<int>(letters.size()), how))
            ImGui::MarkItemEdited(id);
        touched.typing = true;
        touched.typed = letters.data();
        return touched;
    }
    const bool held = ImGui::GetCurrentContext()->ActiveId == id;
    const bool hovered = ImGui::GetCurrentContext()->HoveredId == id;
    const ImGuiCol ground = held ? ImGuiCol_FrameBgActive : hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg;
    ImGui::RenderNavHighlight(frame, id);
    ImGui::RenderFrame(frame.Min, frame.Max, ImGui::GetColorU32(ground), true, look.FrameRounding);
    const std::string format = fmt::format("%.{}f", decimals);
    touched.slid = ImGui::DragBehavior(id, ImGuiDataType_Double, &shown, step, &low, &high, format.c_str(), 0);
    if (touched.slid) ImGui::MarkItemEdited(id);
    if (quiet) ImGui::PushStyleColor(ImGuiCol_Text, style::quiet_text);
    ImGui::RenderTextClipped(frame.Min, frame.Max, text.c_str(), nullptr, nullptr, {0.5F, 0.5F});
    if (quiet) ImGui::PopStyleColor();
    return touched;
}

/// A frame around the item drawn last, and what is wrong with its text below.
void show_fault(const std::string& fault) {
    const float scale = style::scale();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRect(low, high, style::warning, ImGui::GetStyle().FrameRounding, 0, 1.6F * scale);
    ImGui::SetNextWindowPos({low.x, high.y + 4.0F * scale});
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 20.0F);
    ImGui::TextColored(style::colour(style::warning), "%s", tr(std::string_view(fault)).data());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

}  // namespace

bool Form::number(const NumberField& field, double& value) {
    if (!shared_.draws()) return shared_.row(field.name, value);
    const bool mixed = shared_.is_mixed(field.name, value);
    const ShownUnit shown_in = shown_unit(field.unit);
    label(field.label, field.help);
    ImGui::SetNextItemWidth(-unit_width * style::scale());  // units stand in a column of their own
    double shown = value / shown_in.worth;
    const int decimals = shown_in.feet_inches ? 2 : std::max(0, field.decimals - shown_in.fewer_decimals);
    const std::string text = mixed ? std::string(tr("mixed")) : figure_text(value, shown_in, field.decimals);
    const Touched touched =
        figure_field((std::string("##") + field.name).c_str(), shown, static_cast<float>(field.step / shown_in.worth),
                     field.low / shown_in.worth, field.high / shown_in.worth, decimals, text, mixed);
    widgets_.note(field.name);
    const ImGuiID item = ImGui::GetItemID();
    const bool typing = touched.typing && ImGui::TempInputIsActive(item);
    if (touched.typing && touched.typed != text) {
        typing_ = item;
        typed_figure_ = touched.typed;
    }
    const Calculated wished = typing_ == item ? calculated(typed_figure_, shown_in.words, shown_in.bare) : Calculated{};
    const bool wrong = typing_ == item && !wished.value;
    if (wrong && typing && !typed_figure_.empty()) show_fault(wished.fault);
    const bool finished = typing_ == item && !typing;
    if (finished) typing_ = 0;
    const bool given_up = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (finished && wrong && !given_up) refused_ = {item, wished.fault};
    if (refused_.item == item && !typing) show_fault(refused_.fault);
    if (!typing && refused_.item != item) tooltip(field.help);
    unit(shown_in.label.data());
    const bool accepted = finished && wished.value && !given_up;
    if (!accepted && !touched.slid) return false;
    finished_ |= accepted;
    const double result = std::clamp(accepted ? *wished.value : shown * shown_in.worth, field.low, field.high);
    if (!std::isfinite(result) || (result == value && !mixed)) return false;
    value = result;
    shared_.note_change(field.name, value);
    return true;
}

}  // namespace hanei
