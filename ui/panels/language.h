/// The language of everything on the screen.
#pragma once

#include <string>
#include <string_view>

namespace hanei {

enum class Language { english, japanese };

/// For all that is drawn from here on; the UI thread alone.
void speak(Language language);
Language spoken();

/// The English text in the spoken language; the English itself where there is no translation.
/// Texts are looked up whole: a sentence with figures is translated as a format string.
///
/// Returns   a pointer that stays valid for the program's life when given a literal.
const char* tr(const char* english);
std::string_view tr(std::string_view english);

}  // namespace hanei
