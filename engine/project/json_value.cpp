#include "engine/project/json_value.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace hanei {

const JsonValue* JsonValue::find(std::string_view key) const {
    if (kind != Kind::object) return nullptr;
    const auto found = std::find(keys.begin(), keys.end(), key);
    return found == keys.end() ? nullptr : &items[static_cast<std::size_t>(found - keys.begin())];
}

JsonValue& JsonValue::add(std::string key, JsonValue value) {
    keys.push_back(std::move(key));
    items.push_back(std::move(value));
    return items.back();
}

namespace {

JsonValue of_kind(JsonValue::Kind kind) {
    JsonValue value;
    value.kind = kind;
    return value;
}

JsonValue number_of(double number, std::string digits) {
    JsonValue value = of_kind(JsonValue::Kind::number);
    value.number = number;
    value.text = std::move(digits);
    return value;
}

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

/// Decimal point without exponent where people would write it so.
bool reads_well_without_exponent(long double value) {
    const long double size = std::abs(value);
    return size == 0.0L || (size >= 1e-5L && size < 1e15L);
}

}  // namespace

JsonValue json_object() { return of_kind(JsonValue::Kind::object); }
JsonValue json_list() { return of_kind(JsonValue::Kind::list); }

JsonValue json_boolean(bool truth) {
    JsonValue value = of_kind(JsonValue::Kind::boolean);
    value.truth = truth;
    return value;
}

JsonValue json_text(std::string text) {
    JsonValue value = of_kind(JsonValue::Kind::text);
    value.text = std::move(text);
    return value;
}

JsonValue json_number(double value) {
    if (!std::isfinite(value)) {
        JsonValue none = of_kind(JsonValue::Kind::null);
        none.text = "not finite";
        return none;
    }
    if (value == 0.0) return number_of(value, std::signbit(value) ? "-0.0" : "0");
    std::array<char, 64> digits{};
    const auto format = reads_well_without_exponent(value) ? std::chars_format::fixed : std::chars_format::general;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, format).ptr;
    return number_of(value, std::string(digits.data(), end));
}

double scaled(const JsonValue& number, FileUnit unit) {
    constexpr std::ptrdiff_t typed = 15;  // every decimal number of so many digits survives a double
    const auto digits =
        std::count_if(number.text.begin(), number.text.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (digits <= typed) return number.number * static_cast<double>(unit.multiply) / unit.divide;
    long double value = number.number;
    std::from_chars(number.text.data(), number.text.data() + number.text.size(), value);
    return static_cast<double>(value * unit.multiply / unit.divide);
}

JsonValue json_scaled(double value, FileUnit unit) {
    if (!std::isfinite(value) || value == 0.0) return json_number(value);
    const long double shown = value * static_cast<long double>(unit.divide) / unit.multiply;
    std::array<char, 96> digits{};
    char* const begin = digits.data();
    char* const limit = begin + digits.size();
    const auto number_to = [&](const char* end) {
        return number_of(static_cast<double>(shown), std::string(begin, static_cast<std::size_t>(end - begin)));
    };
    for (int decimals = 0; decimals <= 20 && reads_well_without_exponent(shown); ++decimals) {
        JsonValue number = number_to(std::to_chars(begin, limit, shown, std::chars_format::fixed, decimals).ptr);
        std::from_chars(begin, begin + number.text.size(), number.number);
        if (same_bits(scaled(number, unit), value)) return number;
    }
    return number_to(std::to_chars(begin, limit, shown, std::chars_format::scientific, 20).ptr);
}

int line_of(const JsonValue& root, std::string_view path) {
    const JsonValue* at = &root;
    while (!path.empty()) {
        const bool indexed = path.front() == '[';
        if (path.front() == '.' || indexed) path.remove_prefix(1);
        const std::string_view step = path.substr(0, path.find_first_of(indexed ? "]" : ".["));
        path.remove_prefix(std::min(path.size(), step.size() + (indexed ? 1 : 0)));
        std::size_t index = 0;
        if (indexed) std::from_chars(step.data(), step.data() + step.size(), index);
        const bool in_list = indexed && at->is(JsonValue::Kind::list) && index < at->items.size();
        const JsonValue* next = in_list ? &at->items[index] : (indexed ? nullptr : at->find(step));
        if (next == nullptr) break;
        at = next;
    }
    return at->line;
}

}  // namespace hanei
