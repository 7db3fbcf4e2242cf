#include "ui/panels/fonts.h"

#include "ui/panels/japanese.h"

#include <array>
#include <bitset>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <imgui_freetype.h>
#include <iterator>
#include <map>
#include <vector>

namespace hanei::style {
namespace {

constexpr float letter_height = 15.0F;
constexpr float small_letter_height = 12.5F;

/// Files of a family, and how much higher its lines are than its letters (ascent and descent per em):
/// sizes are those of lines, and letters of two families have to stand beside each other.
struct Family {
    const char* regular;
    const char* strong;
    float line_per_em;
};
constexpr std::array latin_families{
    Family{"/usr/share/fonts/opentype/inter/Inter-Regular.otf", "/usr/share/fonts/opentype/inter/Inter-SemiBold.otf",
           1.21F},
    Family{"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf",
           1.164F},
};
constexpr std::array japanese_families{
    Family{"/usr/share/fonts/truetype/bizud-gothic/BIZUDPGothic-Regular.ttf",
           "/usr/share/fonts/truetype/bizud-gothic/BIZUDPGothic-Bold.ttf", 1.0F},
    Family{"/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc",
           "/usr/share/fonts/opentype/noto/NotoSansCJK-Bold.ttc", 1.448F},
    Family{"/usr/share/fonts/opentype/ipaexfont-gothic/ipaexg.ttf",
           "/usr/share/fonts/opentype/ipaexfont-gothic/ipaexg.ttf", 1.0F},
    Family{"/usr/share/fonts/opentype/ipafont-gothic/ipagp.ttf", "/usr/share/fonts/opentype/ipafont-gothic/ipagp.ttf",
           1.0F},
};
constexpr float kanji_share = 1.08F;  // of the Latin letters' em: kanji fill theirs, Latin letters do not

// Latin, Greek (for angles), punctuation with dashes and dots, superscripts, arrows, and +- <= >=.
constexpr ImWchar base_letters[] = {0x20,   0xFF,   0x370,  0x3FF,  0x2010, 0x2027, 0x2030, 0x203A,
                                    0x2070, 0x209F, 0x2190, 0x2199, 0x2205, 0x2206, 0x2211, 0x221E,
                                    0x2248, 0x2248, 0x2260, 0x2265, 0x25A0, 0x25FF, 0};
constexpr unsigned first_eastern = 0x2E80;  // radicals, kana, kanji and full-width forms from here on
constexpr unsigned last_letter = 0xFFFF;    // what an ImWchar holds

struct State {
    Fonts fonts;
    std::bitset<last_letter + 1> loaded, asked;
    bool short_of_letters = false;
    std::string remark;
    std::map<std::string, std::vector<char>> files;
    ImVector<ImWchar> latin_ranges, eastern_ranges;  // the atlas points into them
};

State& state() {
    static State only;
    return only;
}

template <class Families>
const Family* first_installed(const Families& families) {
    for (const Family& family : families) {
        if (std::filesystem::exists(family.regular) && std::filesystem::exists(family.strong)) return &family;
    }
    return nullptr;
}

/// A file is read once: letters are loaded anew from memory.
std::vector<char>& bytes_of(const char* path) {
    std::vector<char>& bytes = state().files[path];
    if (bytes.empty()) {
        std::ifstream file(path, std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(file), {});
    }
    return bytes;
}

ImFont* add(const char* path, float size, const ImVector<ImWchar>& ranges, bool merged) {
    std::vector<char>& bytes = bytes_of(path);
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    config.MergeMode = merged;
    return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(bytes.data(), static_cast<int>(bytes.size()), size, &config,
                                                      ranges.Data);
}

template <class Each>
void for_each_letter(std::string_view utf8, Each each) {
    for (std::size_t i = 0; i < utf8.size();) {
        const auto lead = static_cast<unsigned char>(utf8[i]);
        const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
        unsigned code = length == 1 ? lead : lead & (0xFFU >> (length + 1));
        for (std::size_t k = 1; k < length && i + k < utf8.size(); ++k)
            code = (code << 6) | (static_cast<unsigned char>(utf8[i + k]) & 0x3FU);
        each(code);
        i += length;
    }
}

void gather_ranges() {
    State& now = state();
    ImFontGlyphRangesBuilder latin, eastern;
    latin.AddRanges(base_letters);
    for (unsigned code = 1; code <= last_letter; ++code) {
        if (now.asked[code]) (code < first_eastern ? latin : eastern).AddChar(static_cast<ImWchar>(code));
    }
    now.latin_ranges.clear();
    now.eastern_ranges.clear();
    latin.BuildRanges(&now.latin_ranges);
    eastern.BuildRanges(&now.eastern_ranges);
    now.loaded = now.asked;
    for (const ImWchar* range = base_letters; *range != 0; range += 2) {
        for (unsigned code = range[0]; code <= range[1]; ++code) now.loaded.set(code);
    }
}

}  // namespace

const Fonts& fonts() { return state().fonts; }

void needs(std::string_view text) {
    State& now = state();
    for_each_letter(text, [&](unsigned code) {
        if (code < 0x80 || code > last_letter || now.loaded[code]) return;
        now.asked.set(code);
        now.short_of_letters = true;
    });
}

bool is_short_of_letters() { return state().short_of_letters; }
std::string missing_font_remark() { return state().remark; }
bool has_japanese() { return first_installed(japanese_families) != nullptr; }

void load_fonts(float scale, Language language) {
    State& now = state();
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    if (language == Language::japanese) {
        for (const Translation& entry : japanese()) needs(entry.other);
    }
    gather_ranges();
    now.short_of_letters = false;
    const Family* const latin = first_installed(latin_families);
    const bool is_eastern = now.eastern_ranges.Size > 1;
    const Family* const eastern = is_eastern ? first_installed(japanese_families) : nullptr;
    now.remark = is_eastern && eastern == nullptr
                     ? "Some letters cannot be shown: no Japanese font is installed (fonts-morisawa-bizud-gothic)."
                     : "";
    const auto make = [&](const char* file, const char* eastern_file, float height) {
        ImFont* font = latin != nullptr ? add(file, height * scale, now.latin_ranges, false) : atlas.AddFontDefault();
        if (eastern != nullptr) {
            const float line_per_em = latin != nullptr ? latin->line_per_em : 1.0F;
            add(eastern_file, std::round(height * scale / line_per_em * kanji_share) * eastern->line_per_em,
                now.eastern_ranges, true);
        }
        return font;
    };
    const auto regular = [](const Family* family) { return family != nullptr ? family->regular : nullptr; };
    const auto strong = [](const Family* family) { return family != nullptr ? family->strong : nullptr; };
    now.fonts.regular = make(regular(latin), regular(eastern), letter_height);
    now.fonts.strong = make(strong(latin), strong(eastern), letter_height);
    now.fonts.small = make(regular(latin), regular(eastern), small_letter_height);
    ImGui::GetIO().FontDefault = now.fonts.regular;
}

}  // namespace hanei::style
