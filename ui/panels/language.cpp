#include "ui/panels/language.h"

#include "ui/panels/japanese.h"

#include <algorithm>

namespace hanei {
namespace {

Language language = Language::english;

}  // namespace

void speak(Language wished) { language = wished; }
Language spoken() { return language; }

std::string_view tr(std::string_view english) {
    if (language == Language::english) return english;
    const std::span<const Translation> table = japanese();
    const auto found =
        std::lower_bound(table.begin(), table.end(), english,
                         [](const Translation& entry, std::string_view key) { return entry.english < key; });
    return found != table.end() && found->english == english ? found->other : english;
}

const char* tr(const char* english) { return tr(std::string_view(english)).data(); }

}  // namespace hanei
