/// The Japanese texts of the window, of japanese.tsv: a line a text, English, a tabulator, Japanese.
/// Lines that begin with # are remarks. Photometric terms are those of JIS Z 8113 and JIS Z 9110.
#pragma once

#include <span>
#include <string_view>

namespace hanei {

struct Translation {
    std::string_view english, other;  ///< both end with a zero
};

/// Sorted by the English text, whatever the order of the file.
std::span<const Translation> japanese();

}  // namespace hanei
