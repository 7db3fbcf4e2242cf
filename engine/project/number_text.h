/// Numbers as luminaire files write them: independent of the locale, nothing but plain decimals.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace hanei {

/// Optional sign, digits with a point, optional exponent. Empty for everything else: words, hexadecimal
/// figures, NaN, infinity, and what a double cannot hold.
std::optional<double> decimal_number(std::string_view text);

/// The same with a comma allowed in place of the point, as EULUMDAT files are found to have.
std::optional<double> decimal_number_with_comma(std::string_view text);

/// What a message shows of a word from a file: in quotes, cut to a readable length, unprintable bytes
/// as question marks.
std::string in_quotes(std::string_view word);

}  // namespace hanei
