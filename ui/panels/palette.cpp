#include "ui/panels/palette.h"

#include <algorithm>
#include <cmath>

namespace hanei::style {
namespace {

/// 0xRRGGBB.
constexpr ImU32 rgb(unsigned hex, unsigned opacity = 0xFF) {
    return IM_COL32((hex >> 16) & 0xFF, (hex >> 8) & 0xFF, hex & 0xFF, opacity);
}

constexpr Palette dark{
    .text = rgb(0xE6E8EB),
    .quiet_text = rgb(0xADB3BC),
    .accent = rgb(0xF2B84B),
    .second = rgb(0x7FB4E6),
    .good = rgb(0x7FC88B),
    .warning = rgb(0xF09A66),
    .error = rgb(0xFF8A80),
    .axis_x = rgb(0xF07575),
    .axis_y = rgb(0x7FC86B),
    .axis_z = rgb(0x7FB0F7),
    .furniture = rgb(0xB3A48F),
    .reading = rgb(0x7FC0C5),
    .sight = rgb(0xB3A7E0),
    .ground = rgb(0x17191D),
    .panel = rgb(0x1F2227),
    .popup = rgb(0x262A30),
    .field = rgb(0x2C3037),
    .field_hovered = rgb(0x363B44),
    .field_active = rgb(0x404651),
    .card = rgb(0x14161A, 0xE6),
    .chosen = rgb(0xF2B84B, 0x30),
    .chosen_hovered = rgb(0xF2B84B, 0x40),
    .row = rgb(0xFFFFFF, 0x06),
    .line = rgb(0x343840),
    .border = rgb(0x424751),
    .plot = rgb(0x3C414A),
    .plot_axis = rgb(0x6A717D),
    .shade = rgb(0x000000, 0x96),
    .dimmed = rgb(0x0A0B0D, 0x99),
};

constexpr Palette light{
    .text = rgb(0x1B1E23),
    .quiet_text = rgb(0x4F5661),
    .accent = rgb(0x844800),
    .second = rgb(0x1D55B0),
    .good = rgb(0x1C6434),
    .warning = rgb(0x963800),
    .error = rgb(0xB0121C),
    .axis_x = rgb(0xB02A2A),
    .axis_y = rgb(0x2A6A22),
    .axis_z = rgb(0x1D55B0),
    .furniture = rgb(0x6E5B3F),
    .reading = rgb(0x10666E),
    .sight = rgb(0x5B46A8),
    .ground = rgb(0xE4E6E9),
    .panel = rgb(0xF6F6F4),
    .popup = rgb(0xFFFFFF),
    .field = rgb(0xE6E8EB),
    .field_hovered = rgb(0xDADDE2),
    .field_active = rgb(0xCDD1D8),
    .card = rgb(0xFBFBF9, 0xEC),
    .chosen = rgb(0xE8A020, 0x40),
    .chosen_hovered = rgb(0xE8A020, 0x50),
    .row = rgb(0x000000, 0x06),
    .line = rgb(0xD2D5DA),
    .border = rgb(0xB9BEC6),
    .plot = rgb(0xCBCFD5),
    .plot_axis = rgb(0x858C97),
    .shade = rgb(0x000000, 0x78),
    .dimmed = rgb(0x40444C, 0x80),
};

double channel(ImU32 packed, int shift) { return ((packed >> shift) & 0xFF) / 255.0; }

double linear(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double relative_luminance(ImU32 packed) {
    return 0.2126 * linear(channel(packed, IM_COL32_R_SHIFT)) + 0.7152 * linear(channel(packed, IM_COL32_G_SHIFT)) +
           0.0722 * linear(channel(packed, IM_COL32_B_SHIFT));
}

}  // namespace

const Palette& palette(Theme theme) { return theme == Theme::light ? light : dark; }

ImU32 laid_over(ImU32 top, ImU32 ground) {
    const double share = channel(top, IM_COL32_A_SHIFT);
    const auto mixed = [&](int shift) {
        const double value = share * channel(top, shift) + (1.0 - share) * channel(ground, shift);
        return static_cast<unsigned>(std::lround(255.0 * value));
    };
    return IM_COL32(mixed(IM_COL32_R_SHIFT), mixed(IM_COL32_G_SHIFT), mixed(IM_COL32_B_SHIFT), 0xFF);
}

double contrast(ImU32 top, ImU32 ground) {
    const double above = relative_luminance(laid_over(top, ground)), below = relative_luminance(ground);
    return (std::max(above, below) + 0.05) / (std::min(above, below) + 0.05);
}

}  // namespace hanei::style
