#include "ui/panels/style.h"

#include <algorithm>
#include <cmath>

namespace hanei::style {
namespace {

struct Present {
    Theme theme = Theme::dark;
    Language language = Language::english;
    float scale = 1.0F;
};
Present present;

void set_sizes(ImGuiStyle& look) {
    look.WindowPadding = {12.0F, 10.0F};
    look.FramePadding = {8.0F, 4.0F};
    look.ItemSpacing = {8.0F, 6.0F};
    look.ItemInnerSpacing = {6.0F, 4.0F};
    look.CellPadding = {6.0F, 3.0F};
    look.IndentSpacing = 16.0F;
    look.ScrollbarSize = 11.0F;
    look.GrabMinSize = 9.0F;
    look.WindowRounding = 0.0F;
    look.ChildRounding = 0.0F;
    look.FrameRounding = 4.0F;
    look.PopupRounding = 6.0F;
    look.ScrollbarRounding = 6.0F;
    look.GrabRounding = 4.0F;
    look.TabRounding = 4.0F;
    look.WindowBorderSize = 0.0F;
    look.ChildBorderSize = 0.0F;
    look.PopupBorderSize = 1.0F;
    look.FrameBorderSize = 0.0F;
    look.WindowTitleAlign = {0.0F, 0.5F};
}

void set_colours(ImGuiStyle& look, const Palette& of) {
    const auto set = [&](ImGuiCol which, ImU32 packed) { look.Colors[which] = colour(packed); };
    set(ImGuiCol_Text, of.text);
    set(ImGuiCol_TextDisabled, of.quiet_text);
    set(ImGuiCol_WindowBg, of.panel);
    set(ImGuiCol_ChildBg, none);
    set(ImGuiCol_PopupBg, of.popup);
    set(ImGuiCol_Border, of.border);
    set(ImGuiCol_FrameBg, of.field);
    set(ImGuiCol_FrameBgHovered, of.field_hovered);
    set(ImGuiCol_FrameBgActive, of.field_active);
    set(ImGuiCol_TitleBg, of.popup);
    set(ImGuiCol_TitleBgActive, of.popup);
    set(ImGuiCol_MenuBarBg, of.ground);
    set(ImGuiCol_ScrollbarBg, none);
    set(ImGuiCol_ScrollbarGrab, of.border);
    set(ImGuiCol_ScrollbarGrabHovered, of.plot_axis);
    set(ImGuiCol_ScrollbarGrabActive, of.plot_axis);
    set(ImGuiCol_CheckMark, of.accent);
    set(ImGuiCol_SliderGrab, of.accent);
    set(ImGuiCol_SliderGrabActive, of.accent);
    set(ImGuiCol_Button, of.field);
    set(ImGuiCol_ButtonHovered, of.field_hovered);
    set(ImGuiCol_ButtonActive, of.field_active);
    set(ImGuiCol_Header, of.chosen);
    set(ImGuiCol_HeaderHovered, of.field_hovered);
    set(ImGuiCol_HeaderActive, of.chosen_hovered);
    set(ImGuiCol_Separator, of.line);
    set(ImGuiCol_SeparatorHovered, of.accent);
    set(ImGuiCol_SeparatorActive, of.accent);
    set(ImGuiCol_Tab, none);
    set(ImGuiCol_TabHovered, of.field_hovered);
    set(ImGuiCol_TabActive, of.field);
    set(ImGuiCol_TabUnfocused, none);
    set(ImGuiCol_TabUnfocusedActive, of.field);
    set(ImGuiCol_TableHeaderBg, of.popup);
    set(ImGuiCol_TableBorderStrong, of.line);
    set(ImGuiCol_TableBorderLight, of.line);
    set(ImGuiCol_TableRowBg, none);
    set(ImGuiCol_TableRowBgAlt, of.row);
    set(ImGuiCol_TextSelectedBg, of.chosen_hovered);
    set(ImGuiCol_DragDropTarget, of.accent);
    set(ImGuiCol_NavHighlight, of.accent);
    set(ImGuiCol_PlotLines, of.accent);
    set(ImGuiCol_PlotHistogram, of.accent);
    set(ImGuiCol_ModalWindowDimBg, of.dimmed);
}

void apply_sizes_and_colours() {
    ImGuiStyle look;
    set_sizes(look);
    set_colours(look, palette(present.theme));
    look.ScaleAllSizes(present.scale);
    ImGui::GetStyle() = look;
}

/// The language that can be shown: English where no letters of the other are installed.
Language showable(Language wished) {
    return wished == Language::japanese && !has_japanese() ? Language::english : wished;
}

float within_reach(float scale) { return std::clamp(scale, least_scale, greatest_scale); }

}  // namespace

Colour::operator ImU32() const { return palette(present.theme).*which_; }

void apply(Theme theme, float scale, Language language) {
    present = {theme, showable(language), within_reach(scale)};
    speak(present.language);
    apply_sizes_and_colours();
    load_fonts(present.scale, present.language);
}

bool follow(const Preferences& wished, float screen) {
    const auto scale = within_reach(wished.scale > 0.0 ? static_cast<float>(wished.scale) : screen);
    const Language language = showable(wished.language);
    const bool other_letters = scale != present.scale || language != present.language || is_short_of_letters();
    const bool other_colours = wished.theme != present.theme;
    present = {wished.theme, language, scale};
    speak(language);
    if (other_letters || other_colours) apply_sizes_and_colours();
    if (other_letters) load_fonts(scale, language);
    return other_letters;
}

Theme theme() { return present.theme; }
float scale() { return present.scale; }
float hairline() { return std::max(1.0F, std::floor(present.scale)); }
ImVec4 colour(ImU32 packed) { return ImGui::ColorConvertU32ToFloat4(packed); }

ImU32 faded(ImU32 packed, float share) {
    const auto opacity = static_cast<float>((packed >> IM_COL32_A_SHIFT) & 0xFF) * share;
    return (packed & ~IM_COL32_A_MASK) | (static_cast<ImU32>(opacity) << IM_COL32_A_SHIFT);
}

}  // namespace hanei::style
