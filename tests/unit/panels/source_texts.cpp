#include "source_texts.h"

#include <algorithm>
#include <cctype>

namespace hanei {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Where a quoted piece ends: the place of its closing quote.
std::size_t closing(std::string_view source, std::size_t open) {
    std::size_t at = open + 1;
    while (at < source.size() && source[at] != source[open]) at += source[at] == '\\' ? 2 : 1;
    return std::min(at, source.size() - 1);
}

std::string unescaped(std::string_view raw) {
    std::string text;
    for (std::size_t k = 0; k < raw.size(); ++k) {
        if (raw[k] != '\\' || k + 1 == raw.size()) {
            text += raw[k];
            continue;
        }
        ++k;
        text += raw[k] == 'n' ? '\n' : raw[k] == 't' ? '\t' : raw[k];
    }
    return text;
}

}  // namespace

std::vector<SourceText> literals_of(std::string_view source, const std::string& file) {
    std::vector<SourceText> texts;
    bool adjacent = false;
    int line = 1;
    for (std::size_t at = 0; at < source.size(); ++at) {
        const char c = source[at];
        if (c == '\n') ++line;
        if (source.substr(at, 2) == "//" || source.substr(at, 8) == "#include") {
            at = std::min(source.find('\n', at), source.size()) - 1;
        } else if (c == '\'' && (at == 0 || std::isalnum(static_cast<unsigned char>(source[at - 1])) == 0)) {
            at = closing(source, at);
            adjacent = false;
        } else if (c == '"') {
            const std::size_t end = closing(source, at);
            const std::string text = unescaped(source.substr(at + 1, end - at - 1));
            if (adjacent)
                texts.back().text += text;
            else
                texts.push_back({text, file + ":" + std::to_string(line)});
            at = end;
            adjacent = true;
        } else if (std::isspace(static_cast<unsigned char>(c)) == 0) {
            adjacent = false;
        }
    }
    return texts;
}

bool reads_like_words(std::string_view text) {
    if (text.empty() || text[0] == '#' || text[0] == '/' || text[0] == '%') return false;
    std::size_t longest = 0, run = 0, words = 0;
    for (const char c : text) {
        run = is_letter(c) ? run + 1 : 0;
        longest = std::max(longest, run);
        if (run == 2) ++words;
    }
    if (longest < 2) return false;
    const bool capital = std::any_of(text.begin(), text.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
    const bool spaced = text.find(' ') != std::string_view::npos && words > 1;
    return capital || spaced;
}

}  // namespace hanei
