#include "ui/view/language.h"

#include "ui/view/japanese.h"

#include <algorithm>

namespace hanei {
namespace {

Language language = Language::english;

std::set<std::string, std::less<>>& missed() {
    static std::set<std::string, std::less<>> texts;
    return texts;
}

bool has_words(std::string_view text) {
    const auto is_letter = [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
    };
    return std::count_if(text.begin(), text.end(), is_letter) > 1;
}

const Translation* find(std::string_view english) {
    const std::span<const Translation> table = japanese();
    const auto found =
        std::lower_bound(table.begin(), table.end(), english,
                         [](const Translation& entry, std::string_view key) { return entry.english < key; });
    return found != table.end() && found->english == english ? &*found : nullptr;
}

}  // namespace

void speak(Language wished) { language = wished; }
Language spoken() { return language; }

std::string_view tr(std::string_view english) {
    if (language == Language::english || english.empty()) return english;
    if (const Translation* found = find(english)) return found->other;
    if (has_words(english)) missed().emplace(english);
    return english;
}

const char* tr(const char* english) { return tr(std::string_view(english)).data(); }

std::string phrase(std::string_view english) {
    if (language == Language::english) return std::string(english);
    if (const Translation* whole = find(english)) return std::string(whole->other);
    const std::size_t blank = english.find(' ');
    if (blank == std::string_view::npos) return std::string(tr(english));
    const std::string_view first = english.substr(0, blank), rest = english.substr(blank + 1);
    if (const Translation* counted = find(fmt::format("{{}} {}", rest)))
        return fmt::format(fmt::runtime(counted->other), first);
    if (const Translation* done = find(fmt::format("{} {{}}", first)))
        return fmt::format(fmt::runtime(done->other), phrase(rest));
    return std::string(tr(english));
}

const std::set<std::string, std::less<>>& untranslated() { return missed(); }

}  // namespace hanei
