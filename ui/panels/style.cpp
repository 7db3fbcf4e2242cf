#include "ui/panels/style.h"

#include <array>
#include <filesystem>
#include <imgui_freetype.h>

namespace hanei::style {
namespace {

Fonts present_fonts;
float present_scale = 1.0F;

constexpr float letter_height = 15.0F;
constexpr float small_letter_height = 12.5F;

struct Family {
    const char* regular;
    const char* strong;
};
constexpr std::array families{
    Family{"/usr/share/fonts/opentype/inter/Inter-Regular.otf", "/usr/share/fonts/opentype/inter/Inter-SemiBold.otf"},
    Family{"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"},
};

// Latin, Greek (for angles), punctuation with dashes and dots, superscripts, arrows, and +- <= >=.
constexpr ImWchar letters[] = {0x20,   0xFF,   0x370,  0x3FF,  0x2010, 0x2027, 0x2070, 0x209F,
                               0x2190, 0x21FF, 0x2200, 0x22FF, 0x25A0, 0x25FF, 0};

Fonts load_fonts(float scale) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    for (const Family& family : families) {
        if (!std::filesystem::exists(family.regular) || !std::filesystem::exists(family.strong)) continue;
        return {atlas.AddFontFromFileTTF(family.regular, letter_height * scale, nullptr, letters),
                atlas.AddFontFromFileTTF(family.strong, letter_height * scale, nullptr, letters),
                atlas.AddFontFromFileTTF(family.regular, small_letter_height * scale, nullptr, letters)};
    }
    ImFont* own = atlas.AddFontDefault();
    return {own, own, own};
}

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

void set_colours(ImGuiStyle& look) {
    const auto set = [&](ImGuiCol which, ImU32 packed) { look.Colors[which] = colour(packed); };
    const ImU32 panel = IM_COL32(0x1F, 0x22, 0x27, 0xFF);
    const ImU32 field = IM_COL32(0x2C, 0x30, 0x37, 0xFF);
    const ImU32 field_hovered = IM_COL32(0x37, 0x3C, 0x45, 0xFF);
    const ImU32 field_active = IM_COL32(0x43, 0x49, 0x54, 0xFF);
    const ImU32 line = IM_COL32(0x34, 0x38, 0x40, 0xFF);
    const ImU32 chosen = IM_COL32(0xF2, 0xB8, 0x4B, 0x38);
    const ImU32 chosen_hovered = IM_COL32(0xF2, 0xB8, 0x4B, 0x50);
    set(ImGuiCol_Text, text);
    set(ImGuiCol_TextDisabled, quiet_text);
    set(ImGuiCol_WindowBg, panel);
    set(ImGuiCol_ChildBg, IM_COL32(0, 0, 0, 0));
    set(ImGuiCol_PopupBg, IM_COL32(0x26, 0x2A, 0x30, 0xFC));
    set(ImGuiCol_Border, IM_COL32(0x42, 0x47, 0x51, 0xFF));
    set(ImGuiCol_FrameBg, field);
    set(ImGuiCol_FrameBgHovered, field_hovered);
    set(ImGuiCol_FrameBgActive, field_active);
    set(ImGuiCol_TitleBg, panel);
    set(ImGuiCol_TitleBgActive, panel);
    set(ImGuiCol_MenuBarBg, ground);
    set(ImGuiCol_ScrollbarBg, IM_COL32(0, 0, 0, 0));
    set(ImGuiCol_ScrollbarGrab, field_hovered);
    set(ImGuiCol_ScrollbarGrabHovered, field_active);
    set(ImGuiCol_ScrollbarGrabActive, field_active);
    set(ImGuiCol_CheckMark, accent);
    set(ImGuiCol_SliderGrab, accent);
    set(ImGuiCol_SliderGrabActive, accent);
    set(ImGuiCol_Button, field);
    set(ImGuiCol_ButtonHovered, field_hovered);
    set(ImGuiCol_ButtonActive, field_active);
    set(ImGuiCol_Header, chosen);
    set(ImGuiCol_HeaderHovered, field_hovered);
    set(ImGuiCol_HeaderActive, chosen_hovered);
    set(ImGuiCol_Separator, line);
    set(ImGuiCol_SeparatorHovered, accent);
    set(ImGuiCol_SeparatorActive, accent);
    set(ImGuiCol_Tab, panel);
    set(ImGuiCol_TabHovered, field_hovered);
    set(ImGuiCol_TabActive, field);
    set(ImGuiCol_TabUnfocused, panel);
    set(ImGuiCol_TabUnfocusedActive, field);
    set(ImGuiCol_TableHeaderBg, IM_COL32(0x26, 0x2A, 0x30, 0xFF));
    set(ImGuiCol_TableBorderStrong, line);
    set(ImGuiCol_TableBorderLight, line);
    set(ImGuiCol_TableRowBg, IM_COL32(0, 0, 0, 0));
    set(ImGuiCol_TableRowBgAlt, IM_COL32(0xFF, 0xFF, 0xFF, 0x06));
    set(ImGuiCol_TextSelectedBg, chosen_hovered);
    set(ImGuiCol_NavHighlight, accent);
    set(ImGuiCol_ModalWindowDimBg, IM_COL32(0x0A, 0x0B, 0x0D, 0x99));
}

}  // namespace

Fonts apply(float scale_wished) {
    present_scale = scale_wished;
    ImGuiStyle look;
    set_sizes(look);
    set_colours(look);
    look.ScaleAllSizes(scale_wished);
    ImGui::GetStyle() = look;
    present_fonts = load_fonts(scale_wished);
    return present_fonts;
}

const Fonts& fonts() { return present_fonts; }
float scale() { return present_scale; }
ImVec4 colour(ImU32 packed) { return ImGui::ColorConvertU32ToFloat4(packed); }

}  // namespace hanei::style
