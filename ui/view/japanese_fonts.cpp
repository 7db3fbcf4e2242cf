#include "ui/view/japanese_fonts.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace hanei {
namespace {

constexpr std::array fonts{
    JapaneseFont{"BIZ UDPGothic", "/usr/share/fonts/truetype/bizud-gothic/BIZUDPGothic-Regular.ttf",
                 "/usr/share/fonts/truetype/bizud-gothic/BIZUDPGothic-Bold.ttf", 1.0F},
    JapaneseFont{"Noto Sans CJK JP", "/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc",
                 "/usr/share/fonts/opentype/noto/NotoSansCJK-Bold.ttc", 1.448F},
    JapaneseFont{"IPAexGothic", "/usr/share/fonts/opentype/ipaexfont-gothic/ipaexg.ttf",
                 "/usr/share/fonts/opentype/ipaexfont-gothic/ipaexg.ttf", 1.0F},
    JapaneseFont{"IPAPGothic", "/usr/share/fonts/opentype/ipafont-gothic/ipagp.ttf",
                 "/usr/share/fonts/opentype/ipafont-gothic/ipagp.ttf", 1.0F},
};

const JapaneseFont* first_installed() {
    const auto found = std::find_if(fonts.begin(), fonts.end(), [](const JapaneseFont& font) {
        return std::filesystem::exists(font.regular) && std::filesystem::exists(font.strong);
    });
    return found == fonts.end() ? nullptr : &*found;
}

}  // namespace

const JapaneseFont* japanese_font() {
    static const JapaneseFont* const font = first_installed();
    return font;
}

Letter first_letter(std::string_view utf8) {
    if (utf8.empty()) return {0, 1};
    const auto lead = static_cast<unsigned char>(utf8[0]);
    const std::size_t announced = lead < 0xC0 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    Letter letter{announced == 1 ? lead : lead & (0xFFU >> (announced + 1)), 1};
    while (letter.bytes < std::min(announced, utf8.size())) {
        const auto next = static_cast<unsigned char>(utf8[letter.bytes]);
        if ((next & 0xC0U) != 0x80U) break;  // the letter is cut short
        letter.code = (letter.code << 6) | (next & 0x3FU);
        ++letter.bytes;
    }
    return letter;
}

}  // namespace hanei
