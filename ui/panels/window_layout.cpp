#include "ui/panels/window_layout.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

// Pixels at scale 1.
constexpr float status_height = 28.0F;
constexpr float centre_width = 400.0F;   // what the view wants at least
constexpr float narrow_window = 900.0F;  // less is too little for two columns beside the view
constexpr float low_window = 560.0F;     // where the table gives more room to the view

// Shares of the window.
constexpr float least_centre_share = 0.42F;
constexpr float greatest_column_share = 0.46F;
constexpr float lists_share = 0.42F;
constexpr float greatest_bottom_share = 0.45F;
constexpr float greatest_bottom_share_if_low = 0.38F;

}  // namespace

WindowLayout lay_out(const Preferences& wished, float width, float height, float top, float scale) {
    const float floor = std::max(top + 1.0F, height - std::round(status_height * scale));
    const bool stacked = width < narrow_window * scale;
    const float centre = std::min(centre_width * scale, least_centre_share * width);
    const float sum = (wished.left_width + wished.right_width) * scale;
    const float share = std::min(1.0F, std::max(0.0F, width - centre) / sum);
    const float left = stacked ? 0.0F : std::floor(share * wished.left_width * scale);
    const float right = stacked ? std::floor(std::min(wished.right_width * scale, greatest_column_share * width))
                                : std::floor(share * wished.right_width * scale);
    const float right_edge = width - right;
    const float most = height < low_window * scale ? greatest_bottom_share_if_low : greatest_bottom_share;
    const float bottom = floor - std::floor(std::min(wished.bottom_height * scale, most * (floor - top)));
    WindowLayout made;
    made.stacked = stacked;
    made.right = {right_edge + 1.0F, top, width, floor};
    made.left = {0.0F, top, left, floor};
    if (stacked) {
        const float parting = std::floor(top + lists_share * (floor - top));
        made.left = {right_edge + 1.0F, top, width, parting};
        made.right.top = parting + 1.0F;
    }
    const float begin = stacked ? 0.0F : left + 1.0F;
    made.bottom = {begin, bottom + 1.0F, right_edge, floor};
    made.centre = {begin, top, right_edge, bottom};
    made.status = {0.0F, floor, width, height};
    return made;
}

}  // namespace hanei
