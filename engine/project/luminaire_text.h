/// The text of a luminaire file: its encoding and its lines.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace hanei {

/// UTF-16 with a byte order mark as UTF-8; any other bytes as they are, without a UTF-8 mark.
std::string decoded_text(std::string_view bytes);

/// A piece of text as UTF-8: bytes that are not valid UTF-8 are read as Latin-1, which keeps them apart.
std::string utf8_text(std::string_view bytes);

std::string_view trimmed(std::string_view text);  ///< without blanks and control characters at both ends
bool starts_with_word(std::string_view text, std::string_view upper_case);  ///< whatever its case

/// Lines ended by LF, CR or CR LF, each of which counts as one.
class LineReader {
public:
    explicit LineReader(std::string_view text) : rest_(text) {}

    bool next();                                     ///< to the next line; false after the last
    std::string_view line() const { return line_; }  ///< without its end
    std::string_view rest() const { return rest_; }  ///< all that follows it
    int number() const { return number_; }           ///< counted from 1

private:
    std::string_view rest_;
    std::string_view line_;
    int number_ = 0;
};

}  // namespace hanei
