/// Which installed fonts have Japanese letters.
#pragma once

#include <string_view>

namespace hanei {

struct JapaneseFont {
    const char* name;     ///< of the family
    const char* regular;  ///< files
    const char* strong;
    float line_per_em;  ///< how much higher its lines are than its letters
};

/// BIZ UDPGothic, Noto Sans CJK JP or an IPA gothic, the first that is installed; null: none.
/// Looked for once.
const JapaneseFont* japanese_font();

/// A letter that the Latin fonts lack: radicals, kana, kanji and full-width forms.
constexpr bool is_eastern(unsigned code) { return code >= 0x2E80; }

/// The code of the letter at the beginning of a text, and how many bytes it takes (at least one, and
/// never beyond the end, whatever the bytes are).
struct Letter {
    unsigned code = 0;
    std::size_t bytes = 1;
};
Letter first_letter(std::string_view utf8);

}  // namespace hanei
