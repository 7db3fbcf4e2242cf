/// The Japanese texts of the window.
#pragma once

#include <span>
#include <string_view>

namespace hanei {

struct Translation {
    std::string_view english, other;  ///< both end with a zero
};

/// Sorted by the English text.
std::span<const Translation> japanese();

}  // namespace hanei
