#include "ui/view/tone.h"

#include "ui/view/band_light.h"
#include "ui/view/cell_field.h"
#include "ui/view/colour_scale.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei {
namespace {

constexpr double isolux_width = 1.5;  // pixels of a picture 900 high

double smooth_step(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

float encoded(float linear) {
    return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

float decoded(float shown) { return shown <= 0.04045F ? shown / 12.92F : std::pow((shown + 0.055F) / 1.055F, 2.4F); }

}  // namespace

double automatic_exposure(const Solution& solution) {
    constexpr double mean_shown = 0.78;  // before the shoulder: 0.43 of white after it, a light grey
    double flux = 0.0, area = 0.0;
    const PerPatch<double> reflectance = reflectances(*solution.mesh, *solution.scene);
    for (const DisplayCell& cell : solution.display->cells) {
        const std::array<double, 4> lux = corner_values(*solution.display, cell, LightPart::total);
        const CellFrame frame = frame_of(solution, cell);
        const Vec2 a = frame.corner[2], b = frame.corner[3] - frame.corner[1];
        const double size = std::abs(0.5 * (a.x * b.y - a.y * b.x)) * (frame.triangle ? 0.5 : 1.0);
        flux += size * reflectance[PatchId{cell.patch}] * bilinear(lux, Vec2(0.5)) / std::numbers::pi;
        area += size;
    }
    return flux > 0.0 ? mean_shown * area / flux : 1.0;
}

glm::vec3 encoded_srgb(const glm::vec3& linear) { return {encoded(linear.x), encoded(linear.y), encoded(linear.z)}; }
glm::vec3 linear_srgb(const glm::vec3& shown) { return {decoded(shown.x), decoded(shown.y), decoded(shown.z)}; }

glm::vec3 photographed(const Vec3& luminance) {
    constexpr double white = 8.0;  // what the shoulder brings to full white, in middle exposures
    const Vec3 dark{0.93, 0.98, 1.07}, bright{1.0, 0.985, 0.95};
    Vec3 linear(0.0);
    for (int b = 0; b < 3; ++b) {
        const double contrast = std::pow(std::max(luminance[b], 1e-6), 0.18);  // a film's about the middle
        const double shown = luminance[b] * contrast;
        const double toned = std::clamp(shown * (1.0 + shown / (white * white)) / (1.0 + shown), 0.0, 1.0);
        linear[b] = std::min(toned * glm::mix(dark[b], bright[b], toned), 1.0);
    }
    return glm::vec3(linear);
}

Tone::Tone(const Solution& solution, const ViewOptions& look, double pixel_scale)
    : options_(look), pixel_scale_(pixel_scale), reflectance_(patch_colours(solution)) {
    if (look.scale == Scale::photo) exposure_ = automatic_exposure(solution) * std::exp2(look.exposure);
    if (look.scale == Scale::photo || look.steps != ColourSteps::standard_steps) return;
    borders_ = band_borders(look.range);
    for (std::size_t k = 1; k < borders_.size(); ++k)
        of_band_.push_back(linear_srgb(colour_of(0.5 * (borders_[k - 1] + borders_[k]), look)));
}

glm::vec3 Tone::colour(double lux, const Vec3& bands, std::uint32_t patch, const Vec2& pixel) const {
    if (options_.scale == Scale::photo) return photographed(exposure_ * reflectance_[patch] * bands / std::numbers::pi);
    if (of_band_.empty() || !(lux >= borders_.front()) || lux > borders_.back())
        return linear_srgb(colour_of(lux, options_, pixel.x, pixel.y, pixel_scale_));
    const auto above = std::upper_bound(borders_.begin() + 1, borders_.end() - 1, lux);
    return of_band_[static_cast<std::size_t>(above - borders_.begin() - 1)];
}

IsoluxLines::IsoluxLines(const ViewOptions& look, double pixel_scale)
    : options_(look), width_(isolux_width * pixel_scale) {
    if (look.isolux && look.scale == Scale::false_colour) lines_ = isolux_levels(look);
}

IsoluxLines::Ink IsoluxLines::at(double lux, double steepness) const {
    if (lines_.empty() || !(steepness > 0.0)) return {};
    const double here = std::log(std::max(lux, 1e-9));
    const auto away = [&](double line) { return std::abs(here - std::log(line)); };
    const auto above = std::lower_bound(lines_.begin(), lines_.end(), lux);
    auto line = above == lines_.end() ? above - 1 : above;
    if (line != lines_.begin() && away(*(line - 1)) < away(*line)) --line;
    // A plateau that happens to lie on a step is no line; crowded lines would only blacken.
    const double sloped = smooth_step(5e-6, 5e-5, steepness);
    const double apart = smooth_step(1.5, 5.0, 0.29 / steepness);
    const double cover = sloped * apart * std::clamp(0.5 * width_ + 0.5 - away(*line) / steepness, 0.0, 1.0);
    if (scale_position(*line * 1.0001, options_) < 0.5) return {glm::vec3(1.0F), static_cast<float>(0.5 * cover)};
    return {{0.02F, 0.03F, 0.05F}, static_cast<float>(0.62 * cover)};
}

}  // namespace hanei
