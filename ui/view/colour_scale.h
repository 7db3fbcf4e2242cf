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

/// Where a figure lies on the scale: 0 at the low end, 1 at the high end, outside beyond. With
/// `standard_steps` the middle of its band, all bands equally far apart.
double scale_position(double lux, const ViewOptions& options);
/// Inverse of scale_position for the two continuous scales, and of band borders for the third
/// (bands in equal heights): what the legend puts at a height.
double lux_at(double position, const ViewOptions& options);
/// Height of a figure on the legend: as scale_position, but continuous for steps too.
double legend_position(double lux, const ViewOptions& options);

glm::vec3 colour_of(double lux, const ViewOptions& options);

/// Borders of the colour bands of `standard_steps`: the range's ends and the steps between.
std::vector<double> band_borders(const LuxRange& range);

}  // namespace hanei
