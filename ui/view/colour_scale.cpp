#include "ui/view/colour_scale.h"

#include "ui/view/difference.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei {
namespace {

// Ends of the path in Oklab. Lightness leaves room for one darker and one lighter colour beyond.
constexpr double first_lightness = 0.24, last_lightness = 0.955;
constexpr double first_hue_deg = 305.0, last_hue_deg = 104.0;
constexpr double least_chroma = 0.085, middle_chroma = 0.115;  // Oklab units; sRGB's border is at 0.12 to 0.3
constexpr int path_samples = 4096;                             // 16 an entry: the table's rounding is 1/256

struct Lab {
    double lightness = 0.0, a = 0.0, b = 0.0;
};

Vec3 linear_srgb(const Lab& lab) {
    const double l = std::pow(lab.lightness + 0.3963377774 * lab.a + 0.2158037573 * lab.b, 3.0);
    const double m = std::pow(lab.lightness - 0.1055613458 * lab.a - 0.0638541728 * lab.b, 3.0);
    const double s = std::pow(lab.lightness - 0.0894841775 * lab.a - 1.2914855480 * lab.b, 3.0);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

bool displayable(const Lab& lab) {
    const Vec3 rgb = linear_srgb(lab);
    return rgb.x >= 0.0 && rgb.y >= 0.0 && rgb.z >= 0.0 && rgb.x <= 1.0 && rgb.y <= 1.0 && rgb.z <= 1.0;
}

double encoded(double linear) {
    linear = std::clamp(linear, 0.0, 1.0);
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

/// Chroma that every lightness of the path can show, smooth along it.
Lab on_path(double t) {
    const double hue = (first_hue_deg + (last_hue_deg - first_hue_deg) * t) * std::numbers::pi / 180.0;
    const double lightness = first_lightness + (last_lightness - first_lightness) * t;
    const double arch = std::sin(std::numbers::pi * std::pow(t, 0.8));
    double chroma = least_chroma + (middle_chroma - least_chroma) * arch + 0.04 * t;
    Lab lab{lightness, chroma * std::cos(hue), chroma * std::sin(hue)};
    while (!displayable(lab) && chroma > 0.0) {
        chroma -= 0.001;
        lab = {lightness, chroma * std::cos(hue), chroma * std::sin(hue)};
    }
    return lab;
}

double distance(const Lab& p, const Lab& q) { return std::hypot(p.lightness - q.lightness, p.a - q.a, p.b - q.b); }

std::array<glm::vec3, 256> made_table() {
    std::vector<double> along{0.0};
    Lab before = on_path(0.0);
    for (int k = 1; k <= path_samples; ++k) {
        const Lab here = on_path(static_cast<double>(k) / path_samples);
        along.push_back(along.back() + distance(before, here));
        before = here;
    }
    std::array<glm::vec3, 256> table;
    std::size_t at = 0;
    for (std::size_t entry = 0; entry < table.size(); ++entry) {
        const double wanted = along.back() * static_cast<double>(entry) / 255.0;
        while (at + 2 < along.size() && along[at + 1] < wanted) ++at;
        const double share = (wanted - along[at]) / (along[at + 1] - along[at]);
        const Vec3 rgb = linear_srgb(on_path((static_cast<double>(at) + share) / path_samples));
        table[entry] = glm::vec3(encoded(rgb.x), encoded(rgb.y), encoded(rgb.z));
    }
    return table;
}

double logarithmic_position(double lux, const LuxRange& range) {
    const double low = std::max(range.low, 1e-6 * range.high);
    return std::log(std::max(lux, 1e-9 * low) / low) / std::log(range.high / low);
}

double linear_position(double lux, const LuxRange& range) { return (lux - range.low) / (range.high - range.low); }

}  // namespace

const std::array<glm::vec3, 256>& colour_table() {
    static const std::array<glm::vec3, 256> table = made_table();
    return table;
}

std::vector<double> band_borders(const LuxRange& range) {
    std::vector<double> borders{range.low};
    for (const double step : standard_steps(range)) {
        if (step > range.low * (1.0 + 1e-6) && step < range.high * (1.0 - 1e-6)) borders.push_back(step);
    }
    borders.push_back(range.high);
    return borders;
}

double scale_position(double lux, const ViewOptions& look) {
    if (look.difference) return 0.5 + 0.5 * lux / look.range.high;
    if (look.steps == ColourSteps::logarithmic) return logarithmic_position(lux, look.range);
    if (look.steps == ColourSteps::linear) return linear_position(lux, look.range);
    const std::vector<double> borders = band_borders(look.range);
    if (!(lux >= borders.front())) return -1.0;
    if (lux > borders.back()) return 2.0;
    const auto above = std::upper_bound(borders.begin() + 1, borders.end() - 1, lux);
    const double bands = static_cast<double>(borders.size() - 1);
    return bands < 2.0 ? 0.5 : static_cast<double>(above - borders.begin() - 1) / (bands - 1.0);
}

double legend_position(double lux, const ViewOptions& look) {
    if (look.difference) return scale_position(lux, look);
    if (look.steps != ColourSteps::standard_steps) return scale_position(lux, look);
    const std::vector<double> borders = band_borders(look.range);
    const auto above = std::upper_bound(borders.begin() + 1, borders.end() - 1, lux);
    const double share = (lux - *(above - 1)) / (*above - *(above - 1));
    return (static_cast<double>(above - borders.begin() - 1) + share) / static_cast<double>(borders.size() - 1);
}

double lux_at(double position, const ViewOptions& look) {
    const LuxRange& range = look.range;
    if (look.difference) return (2.0 * position - 1.0) * range.high;
    if (look.steps == ColourSteps::linear) return range.low + position * (range.high - range.low);
    if (look.steps == ColourSteps::logarithmic) {
        const double low = std::max(range.low, 1e-6 * range.high);
        return low * std::pow(range.high / low, position);
    }
    const std::vector<double> borders = band_borders(range);
    const double height = std::clamp(position, 0.0, 1.0) * static_cast<double>(borders.size() - 1);
    const std::size_t band = std::min(static_cast<std::size_t>(height), borders.size() - 2);
    return borders[band] + (height - static_cast<double>(band)) * (borders[band + 1] - borders[band]);
}

namespace {

glm::vec3 difference_colour(double share) {
    const DifferenceColours& of = difference_colours;
    const auto half = static_cast<float>(2.0 * std::min(std::abs(share), 1.0));
    const glm::vec3 middle = share < 0.0 ? of.less : of.more, end = share < 0.0 ? of.much_less : of.much_more;
    return half < 1.0F ? glm::mix(of.none, middle, half) : glm::mix(middle, end, half - 1.0F);
}

}  // namespace

glm::vec3 colour_of(double lux, const ViewOptions& look) {
    if (look.difference)
        return has_counterpart(lux) ? difference_colour(lux / look.range.high) : difference_colours.nothing;
    const double position = scale_position(lux, look);
    if (!(position >= 0.0)) return colour_below;
    if (position > 1.0) return colour_above;
    const auto& table = colour_table();
    const double entry = position * 255.0;
    const std::size_t first = std::min(static_cast<std::size_t>(entry), table.size() - 2);
    const float share = static_cast<float>(entry - static_cast<double>(first));
    return table[first] * (1.0F - share) + table[first + 1] * share;
}

bool is_striped(bool above, double x, double y, double pixel_scale) {
    const auto stripe = [&](double across) {
        const double period = stripe_distance * pixel_scale;
        return across - period * std::floor(across / period) < stripe_width * pixel_scale;
    };
    constexpr double diagonal = 0.7071067811865476;
    return stripe(diagonal * (x + y)) || (above && stripe(diagonal * (x - y)));
}

glm::vec3 colour_of(double lux, const ViewOptions& look, double x, double y, double pixel_scale) {
    if (look.difference) {
        const bool striped = lux < -least_striped_share * look.range.high && is_striped(false, x, y, pixel_scale);
        return (striped ? shade_of_stripe : 1.0F) * colour_of(lux, look);
    }
    if (!look.marks_clipped) return colour_of(lux, look);
    const double position = scale_position(lux, look);
    const bool above = position > 1.0;
    if ((position >= 0.0 && !above) || !is_striped(above, x, y, pixel_scale)) return colour_of(lux, look);
    return above ? stripe_above : stripe_below;
}

}  // namespace hanei
