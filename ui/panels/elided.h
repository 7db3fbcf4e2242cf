/// Text that has less room than it needs: cut with "…", whole in a tooltip.
#pragma once

#include <string>
#include <string_view>

namespace hanei {

/// The part of a text that is left out first.
enum class Elide {
    end,    ///< words
    middle  ///< names that end in what tells them apart: "Panel 600 …, 12"
};

/// The text in the present font, at most this many pixels wide; empty where not even "…" fits.
/// Cost      0.2 us where it fits, 3 us where it is cut.
std::string elided(std::string_view text, float room, Elide elide = Elide::end);

/// Draws the text as the next item, over at most `room` pixels (0: what the line has left); where it was
/// cut, the tooltip says all of it.
void elided_text(std::string_view text, float room = 0.0F, Elide elide = Elide::end);

/// A remark in quiet letters, broken into lines.
void quiet_words(const char* text);

}  // namespace hanei
