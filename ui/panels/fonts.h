/// The letters of the window.
///
/// Inter where it is installed, else DejaVu Sans, else ImGui's own; Japanese from BIZ UDPGothic, Noto
/// Sans CJK JP or an IPA gothic, whichever is there. Letters are loaded when they are needed: the
/// Latin and Greek ones at once, all others with the texts they occur in.
#pragma once

#include "ui/panels/language.h"

#include <imgui.h>
#include <string>
#include <string_view>

namespace hanei::style {

struct Fonts {
    ImFont* regular = nullptr;
    ImFont* strong = nullptr;
    ImFont* small = nullptr;
};

/// The fonts of the present ImGui context.
const Fonts& fonts();

/// Says that this text will be drawn, so that the next frames have its letters. Cheap for a text whose
/// letters are there; a name read from a file, a path, a typed text should go through it.
void needs(std::string_view text);
void needs(ImWchar letter);

/// Letters were asked for that are not loaded.
bool is_short_of_letters();

/// Loads the fonts anew, with the letters of the language's texts and all that were asked for.
void load_fonts(float scale, Language language);

/// A font with Japanese letters is installed.
bool has_japanese();

/// One sentence when letters are needed for which no font is installed; empty otherwise.
std::string missing_font_remark();

}  // namespace hanei::style
