/// How the window looks: one place for its colours, sizes and letters.
#pragma once

#include "ui/panels/fonts.h"
#include "ui/panels/palette.h"

namespace hanei::style {

/// A colour of the present theme, written where a packed colour is wanted: it is looked up there and
/// then, so never keep its ImU32.
class Colour {
public:
    constexpr explicit Colour(ImU32 Palette::*which) : which_(which) {}
    operator ImU32() const;

private:
    ImU32 Palette::*which_;
};

inline constexpr Colour text{&Palette::text};
inline constexpr Colour quiet_text{&Palette::quiet_text};
inline constexpr Colour accent{&Palette::accent};
inline constexpr Colour second{&Palette::second};
inline constexpr Colour good{&Palette::good};
inline constexpr Colour warning{&Palette::warning};
inline constexpr Colour error{&Palette::error};
inline constexpr Colour axis_x{&Palette::axis_x};
inline constexpr Colour axis_y{&Palette::axis_y};
inline constexpr Colour axis_z{&Palette::axis_z};
inline constexpr Colour furniture{&Palette::furniture};
inline constexpr Colour reading{&Palette::reading};
inline constexpr Colour sight{&Palette::sight};
inline constexpr Colour ground{&Palette::ground};
inline constexpr Colour panel{&Palette::panel};
inline constexpr Colour popup{&Palette::popup};
inline constexpr Colour field{&Palette::field};
inline constexpr Colour card{&Palette::card};
inline constexpr Colour chosen{&Palette::chosen};
inline constexpr Colour line{&Palette::line};
inline constexpr Colour border{&Palette::border};
inline constexpr Colour plot{&Palette::plot};
inline constexpr Colour plot_axis{&Palette::plot_axis};
inline constexpr Colour shade{&Palette::shade};
inline constexpr ImU32 none = IM_COL32(0, 0, 0, 0);

inline constexpr float least_scale = 1.0F, greatest_scale = 3.0F;

/// Sets colours, spacing, letters and language of the present ImGui context for a screen of this scale
/// (1: 96 dots an inch; kept within 1 to 3).
/// Needs     no frame under way. Whoever paints has to take up the new letters' picture afterwards.
void apply(Theme theme, float scale, Language language);

/// Follows what is wished, between two frames: colours at once, letters when their size, the language or
/// the letters in use changed. `screen` is the scale where the preferences name none.
/// Returns   true when the letters were made anew: their picture has to be taken up again.
bool follow(const Preferences& wished, float screen);

Theme theme();

/// The scale given to apply(): multiply every size in pixels by it.
float scale();

/// As wide as a line one pixel thick has to be drawn to be crisp: whole pixels, at least one.
float hairline();

ImVec4 colour(ImU32 packed);

/// With this share of its opacity.
ImU32 faded(ImU32 packed, float share);

}  // namespace hanei::style
