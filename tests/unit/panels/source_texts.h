/// The texts a user may see, as they stand in the sources.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hanei {

struct SourceText {
    std::string text;
    std::string place;  ///< "legend.cpp:81"
};

/// String literals of a C++ source with adjacent ones joined; not those of #include lines and remarks.
std::vector<SourceText> literals_of(std::string_view source, const std::string& file);

/// It has a word of two letters or more, and is neither a widget's name ("light.dimmer", "##fields"), nor a
/// path, nor a format of figures alone.
bool reads_like_words(std::string_view text);

}  // namespace hanei
