/// How the window looks: one place for its colours, sizes and letters.
#pragma once

#include <imgui.h>

namespace hanei::style {

inline constexpr ImU32 accent = IM_COL32(0xF2, 0xB8, 0x4B, 0xFF);  ///< lamp light: what is lit and selected
inline constexpr ImU32 text = IM_COL32(0xE3, 0xE5, 0xE8, 0xFF);
inline constexpr ImU32 quiet_text = IM_COL32(0x93, 0x99, 0xA3, 0xFF);  ///< units, captions, what is stale
inline constexpr ImU32 good = IM_COL32(0x7F, 0xC8, 0x8B, 0xFF);
inline constexpr ImU32 warning = IM_COL32(0xE8, 0x8E, 0x5A, 0xFF);
inline constexpr ImU32 ground = IM_COL32(0x17, 0x19, 0x1D, 0xFF);  ///< behind everything
inline constexpr ImU32 axis_x = IM_COL32(0xE5, 0x5F, 0x5F, 0xFF);
inline constexpr ImU32 axis_y = IM_COL32(0x7F, 0xC8, 0x6B, 0xFF);
inline constexpr ImU32 axis_z = IM_COL32(0x63, 0x9C, 0xF0, 0xFF);

struct Fonts {
    ImFont* regular = nullptr;
    ImFont* strong = nullptr;
    ImFont* small = nullptr;
};

/// Sets colours, spacing and letters of the present ImGui context for a screen of this scale
/// (1: 96 dots an inch). Inter when it is installed, else DejaVu Sans, else ImGui's own.
Fonts apply(float scale);

/// The fonts that apply() loaded last into the present context.
const Fonts& fonts();

/// The scale given to apply(): multiply every size in pixels by it.
float scale();

ImVec4 colour(ImU32 packed);

}  // namespace hanei::style
