#include "engine/project/number_text.h"

#include <charconv>
#include <cmath>

namespace hanei {
namespace {

bool is_plain(std::string_view text) { return text.find_first_not_of("0123456789+-.eE") == std::string_view::npos; }

}  // namespace

std::optional<double> decimal_number(std::string_view text) {
    if (!is_plain(text)) return std::nullopt;
    if (text.starts_with('+')) {
        text.remove_prefix(1);
        if (text.starts_with('-')) return std::nullopt;
    }
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stopped != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<double> decimal_number_with_comma(std::string_view text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) return decimal_number(text);
    constexpr std::size_t longest = 400;  // more digits than any double has before or after its point
    if (text.size() > longest || text.find('.') != std::string_view::npos) return std::nullopt;
    std::string with_point{text};
    with_point[comma] = '.';
    return decimal_number(with_point);
}

std::string in_quotes(std::string_view word) {
    constexpr std::size_t longest = 40;
    std::string shown = "\"";
    for (const char c : word.substr(0, longest)) shown += c >= ' ' && c <= '~' ? c : '?';
    return shown + (word.size() > longest ? "...\"" : "\"");
}

}  // namespace hanei
