/// From lux to colour: one function for the picture, the legend and the dots.
#pragma once

#include "ui/view/view_options.h"

#include <glm/vec3.hpp>

#include <array>

namespace hanei {

/// The sequential map: 256 sRGB colours (0 to 1) from dark violet over blue and green to light
/// yellow. It is our own: a path through Oklab (B. Ottosson 2020, "A perceptual color space for
/// image processing") along which lightness rises evenly and hue runs from violet to yellow through
/// blue and green, chroma held inside sRGB; entries lie at equal distances along the path, so equal
/// steps look equal. Monotone in lightness: it survives a grey print and colour blindness.
const std::array<glm::vec3, 256>& colour_table();

/// Beyond the ends: darker and lighter than the map ever is.
inline constexpr glm::vec3 colour_below{0.055F, 0.035F, 0.10F};
inline constexpr glm::vec3 colour_above{1.0F, 0.995F, 0.95F};

/// Where figures outside the range are marked, these are drawn over the colours beyond the ends: falling
/// stripes below, crossed ones above, so that neither hue nor lightness alone tells them.
inline constexpr glm::vec3 stripe_below{0.44F, 0.46F, 0.56F};
inline constexpr glm::vec3 stripe_above{0.78F, 0.08F, 0.20F};
inline constexpr double stripe_distance = 7.0, stripe_width = 1.6;  // pixels of a picture 900 high

/// Whether a stripe passes here; in pixels from the left and from the bottom.
bool is_striped(bool above, double x, double y, double pixel_scale);

/// Where a figure lies on the scale: 0 at the low end, 1 at the high end, outside beyond. With
/// `standard_steps` the middle of its band, all bands equally far apart.
double scale_position(double lux, const ViewOptions& options);
/// Inverse of scale_position for the two continuous scales, and of band borders for the third
/// (bands in equal heights): what the legend puts at a height.
double lux_at(double position, const ViewOptions& options);
/// Height of a figure on the legend: as scale_position, but continuous for steps too.
double legend_position(double lux, const ViewOptions& options);

glm::vec3 colour_of(double lux, const ViewOptions& options);
/// The same at a place of the picture (pixels from the left and from the bottom), with its hatching.
glm::vec3 colour_of(double lux, const ViewOptions& options, double x, double y, double pixel_scale);

/// Of differences: blue for less, orange for more, paler towards none, and grey where there is nothing to
/// compare. Less is striped besides, so that hue alone does not tell.
struct DifferenceColours {
    glm::vec3 much_less{0.08F, 0.24F, 0.58F}, less{0.36F, 0.62F, 0.88F}, none{0.93F, 0.93F, 0.91F};
    glm::vec3 more{0.97F, 0.64F, 0.27F}, much_more{0.68F, 0.24F, 0.03F}, nothing{0.50F, 0.50F, 0.52F};
};
inline constexpr DifferenceColours difference_colours;
inline constexpr float shade_of_stripe = 0.72F;      ///< of the colour, in the stripes of less
inline constexpr double least_striped_share = 0.02;  ///< of the range: smaller differences have no stripes

/// Borders of the colour bands of `standard_steps`: the range's ends and the steps between.
std::vector<double> band_borders(const LuxRange& range);

}  // namespace hanei
