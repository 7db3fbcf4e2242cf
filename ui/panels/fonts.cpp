#include "ui/panels/fonts.h"

#include "ui/view/japanese.h"
#include "ui/view/japanese_fonts.h"

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
constexpr float kanji_share = 1.08F;  // of the Latin letters' em: kanji fill theirs, Latin letters do not

// Latin, Greek (for angles), punctuation with dashes and dots, superscripts, arrows, and +- <= >=.
constexpr ImWchar base_letters[] = {0x20,   0xFF,   0x370,  0x3FF,  0x2010, 0x2027, 0x2030, 0x203A,
                                    0x2070, 0x209F, 0x2190, 0x2199, 0x2205, 0x2206, 0x2211, 0x221E,
                                    0x2248, 0x2248, 0x2260, 0x2265, 0x25A0, 0x25FF, 0};
constexpr unsigned last_letter = 0xFFFF;  // what an ImWchar holds

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

const Family* latin_family() {
    for (const Family& family : latin_families) {
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

void gather_ranges() {
    State& now = state();
    ImFontGlyphRangesBuilder latin, eastern;
    latin.AddRanges(base_letters);
    for (unsigned code = 1; code <= last_letter; ++code) {
        if (now.asked[code]) (is_eastern(code) ? eastern : latin).AddChar(static_cast<ImWchar>(code));
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

void needs(ImWchar letter) {
    State& now = state();
    if (letter < 0x80 || now.loaded[letter]) return;
    now.asked.set(letter);
    now.short_of_letters = true;
}

void needs(std::string_view text) {
    while (!text.empty()) {
        const Letter letter = first_letter(text);
        text.remove_prefix(letter.bytes);
        if (letter.code >= 0x80 && letter.code <= last_letter) needs(static_cast<ImWchar>(letter.code));
    }
}

bool is_short_of_letters() { return state().short_of_letters; }
std::string missing_font_remark() { return state().remark; }
bool has_japanese() { return japanese_font() != nullptr; }

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
    const Family* const latin = latin_family();
    const bool any_eastern = now.eastern_ranges.Size > 1;
    const JapaneseFont* const eastern = any_eastern ? japanese_font() : nullptr;
    now.remark = any_eastern && eastern == nullptr
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
    const auto regular = [](const auto* family) { return family != nullptr ? family->regular : nullptr; };
    const auto strong = [](const auto* family) { return family != nullptr ? family->strong : nullptr; };
    now.fonts.regular = make(regular(latin), regular(eastern), letter_height);
    now.fonts.strong = make(strong(latin), strong(eastern), letter_height);
    now.fonts.small = make(regular(latin), regular(eastern), small_letter_height);
    ImGui::GetIO().FontDefault = now.fonts.regular;
}

}  // namespace hanei::style
