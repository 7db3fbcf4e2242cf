#include "ui/view/png_text.h"

#include <cstdint>
#include <fstream>
#include <string_view>

namespace hanei {
namespace {

std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (const char byte : bytes.substr(0, 4)) value = value << 8U | static_cast<unsigned char>(byte);
    return value;
}

std::string utf8_of(std::string_view latin) {
    std::string text;
    for (const char letter : latin) {
        const auto code = static_cast<unsigned char>(letter);
        if (code < 0x80) {
            text += letter;
        } else {
            text += static_cast<char>(0xC0U | code >> 6U);
            text += static_cast<char>(0x80U | (code & 0x3FU));
        }
    }
    return text;
}

/// Up to the next zero, which is taken away as well; the rest when there is none.
std::string_view take_word(std::string_view& bytes) {
    const std::size_t end = std::min(bytes.find('\0'), bytes.size());
    const std::string_view word = bytes.substr(0, end);
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    return word;
}

void take_international(std::string_view content, PngText& text) {
    const std::string_view key = take_word(content);
    if (content.size() < 2 || content[0] != 0) return;  // packed
    content.remove_prefix(2);
    take_word(content);  // language
    take_word(content);  // the key in that language
    text.emplace_back(key, content);
}

}  // namespace

std::optional<PngText> read_png_text(const std::filesystem::path& file) {
    std::error_code failure;
    if (!std::filesystem::is_regular_file(file, failure)) return std::nullopt;
    std::ifstream stream(file, std::ios::binary);
    const std::string all{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    std::string_view bytes = all;
    constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
    if (bytes.substr(0, signature.size()) != signature) return std::nullopt;
    bytes.remove_prefix(signature.size());
    PngText text;
    while (bytes.size() >= 12) {
        const std::size_t size = big_endian(bytes);
        const std::string_view kind = bytes.substr(4, 4);
        if (size > bytes.size() - 12) return std::nullopt;
        std::string_view content = bytes.substr(8, size);
        if (kind == "IEND") return text;
        if (kind == "iTXt") take_international(content, text);
        if (kind == "tEXt") {
            const std::string_view key = take_word(content);
            text.emplace_back(utf8_of(key), utf8_of(content));
        }
        bytes.remove_prefix(size + 12);
    }
    return std::nullopt;
}

}  // namespace hanei
