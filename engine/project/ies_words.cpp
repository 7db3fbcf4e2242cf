#include "engine/project/ies_words.h"

#include "engine/project/number_text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

/// Everything up to the blank, and the comma: control characters part words as blanks do.
bool is_separator(char c) { return static_cast<unsigned char>(c) <= ' ' || c == ','; }

std::size_t count_words(std::string_view text) {
    std::size_t count = 0;
    bool inside = false;
    for (const char c : text) {
        const bool separator = is_separator(c);
        if (!separator && !inside) ++count;
        inside = !separator;
    }
    return count;
}

}  // namespace

IesWords::IesWords(std::string_view text, int first_line, LuminaireFindings& findings)
    : rest_(text), at_line_(first_line), line_(first_line - 1), left_(count_words(text)), findings_(findings) {}

void IesWords::skip_separators() {
    std::size_t k = 0;
    for (; k < rest_.size() && is_separator(rest_[k]); ++k) {
        const bool first_of_pair = rest_[k] == '\r' && k + 1 < rest_.size() && rest_[k + 1] == '\n';
        if (rest_[k] == '\n' || (rest_[k] == '\r' && !first_of_pair)) ++at_line_;
    }
    rest_.remove_prefix(k);
}

std::string_view IesWords::take() {
    skip_separators();
    line_ = at_line_;
    const auto end = std::find_if(rest_.begin(), rest_.end(), is_separator);
    const std::string_view word = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
    rest_.remove_prefix(word.size());
    --left_;
    return word;
}

int IesWords::next_line() {
    skip_separators();
    return at_line_;
}

double IesWords::number_of(std::size_t count, std::size_t position, std::string_view field) {
    if (findings_.failed()) return 0.0;
    if (left_ == 0) {
        findings_.fault(std::max(line_, 1), std::string{field},
                        count == 1 ? "the file ends before this number"
                                   : fmt::format("the file ends after {} of {} values", position, count));
        return 0.0;
    }
    const std::string_view word = take();
    const std::optional<double> value = decimal_number(word);
    if (!value) {
        findings_.fault(line_, std::string{field},
                        fmt::format("{} is no number; a plain decimal number is needed", in_quotes(word)));
    }
    return value.value_or(0.0);
}

double IesWords::number(std::string_view field, const AllowedRange& allowed) {
    const double value = number_of(1, 0, field);
    if (!findings_.failed() && !allowed.holds(value)) {
        findings_.fault(line_, std::string{field}, fmt::format("{} found, allowed is {}", value, allowed.text));
        return 0.0;
    }
    return value;
}

int IesWords::whole(std::string_view field, const AllowedRange& allowed) {
    const double value = number(field, allowed);
    if (value != std::floor(value)) {
        findings_.fault(line_, std::string{field}, fmt::format("{} found, allowed is {}", value, allowed.text));
        return 0;
    }
    return static_cast<int>(value);
}

std::vector<double> IesWords::numbers(std::size_t count, std::string_view field) {
    std::vector<double> values;
    values.reserve(std::min(count, left_));
    for (std::size_t k = 0; k < count && !findings_.failed(); ++k) values.push_back(number_of(count, k, field));
    if (findings_.failed()) values.clear();
    return values;
}

std::vector<double> IesWords::increasing(std::size_t count, std::string_view field, const AllowedRange& allowed) {
    std::vector<double> values;
    values.reserve(std::min(count, left_));
    for (std::size_t k = 0; k < count && !findings_.failed(); ++k) {
        const double value = number_of(count, k, field);
        if (findings_.failed()) break;
        if (!allowed.holds(value)) {
            findings_.fault(line_, std::string{field}, fmt::format("{} found, allowed is {}", value, allowed.text));
        } else if (k > 0 && !(value > values.back())) {
            findings_.fault(line_, std::string{field},
                            fmt::format("{} follows {}; angles must increase", value, values.back()));
        }
        values.push_back(value);
    }
    if (findings_.failed()) values.clear();
    return values;
}

}  // namespace hanei
