/// The language of everything on the screen and in pictures.
#pragma once

#include <fmt/format.h>
#include <set>
#include <string>
#include <string_view>

namespace hanei {

enum class Language { english, japanese };

/// For all that is drawn from here on; one thread alone.
void speak(Language language);
Language spoken();

/// The English text in the spoken language; the English itself where there is no translation.
/// Texts are looked up whole, in ui/view/japanese.tsv.
///
/// Returns   a pointer that stays valid for the program's life when given a literal.
const char* tr(const char* english);
std::string_view tr(std::string_view english);

/// A sentence with figures: its words are translated as one format string, whose placeholders may be
/// numbered where the other language orders them differently.
template <class... Parts>
std::string say(const char* english, const Parts&... parts) {
    return fmt::format(fmt::runtime(tr(english)), parts...);
}

/// Words made of words: "Move luminaire", "Delete 3 luminaires", "3 luminaires". Looked up whole, else by
/// their parts ("Move {}", "{} luminaires").
std::string phrase(std::string_view english);

/// Texts with letters that were asked for in another language and are not in its table.
const std::set<std::string, std::less<>>& untranslated();

}  // namespace hanei
