#include "engine/project/luminaire_text.h"

#include <cstdint>

namespace hanei {
namespace {

void append_utf8(std::string& text, std::uint32_t code) {
    const auto push = [&text](std::uint32_t byte) { text.push_back(static_cast<char>(byte)); };
    if (code < 0x80) return push(code);
    if (code < 0x800) {
        push(0xC0 | (code >> 6));
    } else if (code < 0x10000) {
        push(0xE0 | (code >> 12));
        push(0x80 | ((code >> 6) & 0x3F));
    } else {
        push(0xF0 | (code >> 18));
        push(0x80 | ((code >> 12) & 0x3F));
        push(0x80 | ((code >> 6) & 0x3F));
    }
    push(0x80 | (code & 0x3F));
}

std::uint32_t byte_at(std::string_view bytes, std::size_t place) { return static_cast<unsigned char>(bytes[place]); }

constexpr std::uint32_t replacement = 0xFFFD;

std::string from_utf16(std::string_view bytes, bool big_endian) {
    const auto unit = [&](std::size_t k) {
        const std::uint32_t first = byte_at(bytes, k);
        const std::uint32_t second = byte_at(bytes, k + 1);
        return big_endian ? first << 8 | second : second << 8 | first;
    };
    std::string text;
    for (std::size_t k = 2; k + 1 < bytes.size(); k += 2) {
        std::uint32_t code = unit(k);
        if (code >= 0xD800 && code < 0xE000) {
            const bool pair = code < 0xDC00 && k + 3 < bytes.size() && unit(k + 2) >= 0xDC00 && unit(k + 2) < 0xE000;
            code = pair ? 0x10000 + ((code - 0xD800) << 10) + (unit(k + 2) - 0xDC00) : replacement;
            if (pair) k += 2;
        }
        append_utf8(text, code);
    }
    return text;
}

/// Bytes of the character at `place`; 0 when it is not valid UTF-8.
std::size_t utf8_length(std::string_view bytes, std::size_t place) {
    const std::uint32_t lead = byte_at(bytes, place);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || place + length > bytes.size()) return 0;
    for (std::size_t k = 1; k < length; ++k) {
        if ((byte_at(bytes, place + k) & 0xC0) != 0x80) return 0;
    }
    const std::uint32_t second = byte_at(bytes, place + 1);
    const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
    const bool surrogate = lead == 0xED && second >= 0xA0;
    const bool past_the_end = lead == 0xF4 && second >= 0x90;
    return overlong || surrogate || past_the_end ? 0 : length;
}

bool is_utf8(std::string_view bytes) {
    for (std::size_t place = 0; place < bytes.size();) {
        const std::size_t length = utf8_length(bytes, place);
        if (length == 0) return false;
        place += length;
    }
    return true;
}

}  // namespace

std::string decoded_text(std::string_view bytes) {
    if (bytes.starts_with("\xFF\xFE")) return from_utf16(bytes, false);
    if (bytes.starts_with("\xFE\xFF")) return from_utf16(bytes, true);
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    return std::string{bytes};
}

std::string utf8_text(std::string_view bytes) {
    if (is_utf8(bytes)) return std::string{bytes};
    std::string text;
    for (std::size_t k = 0; k < bytes.size(); ++k) append_utf8(text, byte_at(bytes, k));
    return text;
}

std::string_view trimmed(std::string_view text) {
    const auto is_blank = [](char c) { return static_cast<unsigned char>(c) <= ' '; };
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

bool starts_with_word(std::string_view text, std::string_view upper_case) {
    if (text.size() < upper_case.size()) return false;
    for (std::size_t k = 0; k < upper_case.size(); ++k) {
        const char c = text[k];
        if ((c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c) != upper_case[k]) return false;
    }
    return true;
}

bool LineReader::next() {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find_first_of("\r\n");
    line_ = rest_.substr(0, end);
    ++number_;
    if (end == std::string_view::npos) {
        rest_ = {};
        return true;
    }
    const bool pair = rest_[end] == '\r' && end + 1 < rest_.size() && rest_[end + 1] == '\n';
    rest_.remove_prefix(end + (pair ? 2 : 1));
    return true;
}

}  // namespace hanei
