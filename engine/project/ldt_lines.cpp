#include "engine/project/ldt_lines.h"

#include "engine/project/number_text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace hanei {
namespace {

std::size_t count_lines(std::string_view text) {
    LineReader lines{text};
    while (lines.next()) continue;
    return static_cast<std::size_t>(lines.number());
}

}  // namespace

LdtLines::LdtLines(std::string_view text, LuminaireFindings& findings)
    : lines_(text), left_(count_lines(text)), findings_(findings) {}

bool LdtLines::take(std::string_view field) {
    if (findings_.failed()) return false;
    if (!lines_.next()) {
        findings_.fault(line() + 1, std::string{field}, "the file ends before this line");
        return false;
    }
    --left_;
    return true;
}

std::string_view LdtLines::text(std::string_view field) {
    if (!take(field)) return {};
    const std::string_view value = trimmed(lines_.line());
    header_.emplace_back(std::string{field}, utf8_text(value));
    return value;
}

double LdtLines::parsed(std::string_view field) {
    const std::string_view word = trimmed(lines_.line());
    const std::optional<double> value = decimal_number_with_comma(word);
    if (!value) {
        findings_.fault(line(), std::string{field},
                        word.empty() ? "the line is blank; a number is needed"
                                     : in_quotes(word) + " is no number; a plain decimal number is needed");
    }
    return value.value_or(0.0);
}

double LdtLines::number(std::string_view field, const AllowedRange& allowed) {
    if (!take(field)) return 0.0;
    header_.emplace_back(std::string{field}, utf8_text(trimmed(lines_.line())));
    const double value = parsed(field);
    if (!allowed.holds(value)) {
        findings_.fault(line(), std::string{field}, fmt::format("{} found, allowed is {}", value, allowed.text));
        return 0.0;
    }
    return value;
}

int LdtLines::whole(std::string_view field, const AllowedRange& allowed) {
    const double value = number(field, allowed);
    if (value != std::floor(value)) {
        findings_.fault(line(), std::string{field}, fmt::format("{} found, allowed is {}", value, allowed.text));
        return 0;
    }
    return static_cast<int>(value);
}

std::vector<double> LdtLines::numbers(std::size_t count, std::string_view field) {
    std::vector<double> values;
    values.reserve(std::min(count, left_));
    while (values.size() < count && take(field)) values.push_back(parsed(field));
    if (findings_.failed()) values.clear();
    return values;
}

std::vector<double> LdtLines::increasing(std::size_t count, std::string_view field, const AllowedRange& allowed) {
    std::vector<double> values;
    values.reserve(std::min(count, left_));
    while (values.size() < count && take(field)) {
        const double value = parsed(field);
        if (!allowed.holds(value)) {
            findings_.fault(line(), std::string{field}, fmt::format("{} found, allowed is {}", value, allowed.text));
        } else if (!values.empty() && !(value > values.back())) {
            findings_.fault(line(), std::string{field},
                            fmt::format("{} follows {}; angles must increase", value, values.back()));
        }
        values.push_back(value);
    }
    if (findings_.failed()) values.clear();
    return values;
}

int LdtLines::first_line_with_text() {
    while (lines_.next()) {
        if (!trimmed(lines_.line()).empty()) return line();
    }
    return 0;
}

}  // namespace hanei
