#include "engine/scene/colour.h"

#include "engine/scene/dimmers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

namespace hanei {
namespace {

constexpr Vec3 white{1.0};

/// Chromaticity coordinates x, y of CIE 1931.
Vec2 black_body(double t) {
    const double u =
        (0.860117757 + 1.54118254e-4 * t + 1.28641212e-7 * t * t) / (1.0 + 8.42420235e-4 * t + 7.08145163e-7 * t * t);
    const double v =
        (0.317398726 + 4.22806245e-5 * t + 4.20481691e-8 * t * t) / (1.0 - 2.89741816e-5 * t + 1.61456053e-7 * t * t);
    return Vec2(3.0 * u, 2.0 * v) / (2.0 * u - 8.0 * v + 4.0);
}

Vec2 daylight(double t) {
    const double k = 1000.0 / t;
    const double x = t <= 7000.0 ? 0.244063 + k * (0.09911 + k * (2.9678 - k * 4.6070))
                                 : 0.237040 + k * (0.24748 + k * (1.9018 - k * 2.0064));
    return {x, -3.0 * x * x + 2.870 * x - 0.275};
}

/// Linear sRGB of a chromaticity at Y = 1 (IEC 61966-2-1).
Vec3 primaries(const Vec2& xy) {
    const Vec3 xyz{xy.x / xy.y, 1.0, (1.0 - xy.x - xy.y) / xy.y};
    return {3.2406255 * xyz.x - 1.5372080 * xyz.y - 0.4986286 * xyz.z,
            -0.9689307 * xyz.x + 1.8757561 * xyz.y + 0.0415175 * xyz.z,
            0.0557101 * xyz.x - 0.2040211 * xyz.y + 1.0569959 * xyz.z};
}

/// With luminance 1.
Vec3 of_unit_luminance(const Vec3& bands) {
    const Vec3 seen = glm::max(bands, Vec3(0.0));
    return seen / luminance(seen);
}

double encoded(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double decoded(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }

/// A number, with or without " K" after it.
std::optional<double> kelvin_of(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return std::nullopt;
    text.remove_prefix(first);
    double kelvin = 0.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), kelvin);
    if (fault != std::errc{}) return std::nullopt;
    std::string_view rest(end, static_cast<std::size_t>(text.data() + text.size() - end));
    while (!rest.empty() && (rest.front() == ' ' || rest.front() == '\t')) rest.remove_prefix(1);
    while (!rest.empty() && (rest.back() == ' ' || rest.back() == '\t')) rest.remove_suffix(1);
    if (!rest.empty() && rest != "K" && rest != "k") return std::nullopt;
    const bool possible = kelvin >= lowest_colour_temperature && kelvin <= highest_colour_temperature;
    return possible ? std::optional(kelvin) : std::nullopt;
}

bool emits_by_itself(const FreeSurface& surface) { return surface.own_exitance.value > 0.0; }

std::set<ObjectId> materials_shown(const Scene& scene) {
    std::set<ObjectId> shown;
    if (scene.room) {
        shown.insert(scene.room->floor_material);
        shown.insert(scene.room->ceiling_material);
        shown.insert(scene.room->wall_materials.begin(), scene.room->wall_materials.end());
        for (const SubArea& area : scene.room->sub_areas) shown.insert(area.material);
    }
    for (const Furniture& furniture : scene.furniture)
        for (const Part& part : furniture.parts) shown.insert(part.material);
    for (const FreeSurface& surface : scene.surfaces) shown.insert(surface.material);
    return shown;
}

}  // namespace

double luminance(const Vec3& bands) { return glm::dot(bands, luminance_weights); }

std::array<double, 3> band_reflectances(const Material& material) {
    std::array<double, 3> bands{};
    for (int b = 0; b < colour_bands; ++b) bands[b] = std::clamp(material.reflectance * material.tint[b], 0.0, 1.0);
    return bands;
}

Vec3 light_of_temperature(double kelvin) {
    const double t = std::clamp(kelvin, lowest_colour_temperature, highest_colour_temperature);
    const double day = std::clamp((t - 4000.0) / 1000.0, 0.0, 1.0);
    if (day <= 0.0) return of_unit_luminance(primaries(black_body(t)));
    if (day >= 1.0) return of_unit_luminance(primaries(daylight(t)));
    return of_unit_luminance(glm::mix(primaries(black_body(t)), primaries(daylight(t)), day));
}

std::optional<double> stated_colour_temperature(const Photometry& photometry) {
    for (const auto& [keyword, text] : photometry.keywords)
        if (keyword == colour_temperature_keyword) return kelvin_of(text);
    if (photometry.lamp_set >= photometry.lamp_sets.size()) return std::nullopt;
    return kelvin_of(photometry.lamp_sets[photometry.lamp_set].colour);
}

Vec3 reference_white(const Scene& scene) {
    double reciprocals = 0.0;
    for (const Luminaire& lamp : scene.luminaires) {
        const double kelvin = colour_temperature_of(scene, lamp);
        if (kelvin <= 0.0) return white;
        reciprocals += 1.0 / kelvin;
    }
    const bool is_neutral_light = std::any_of(scene.surfaces.begin(), scene.surfaces.end(), emits_by_itself);
    if (is_neutral_light || reciprocals <= 0.0) return white;
    return light_of_temperature(static_cast<double>(scene.luminaires.size()) / reciprocals);
}

Vec3 band_output(const Luminaire& luminaire, const Scene& scene) {
    const double kelvin = colour_temperature_of(scene, luminaire);
    if (kelvin <= 0.0 || is_light_of_one_colour(scene)) return white;
    constexpr double least_of_a_band = 0.02;
    const Vec3 adapted = glm::max(reference_white(scene), Vec3(least_of_a_band));
    return of_unit_luminance(light_of_temperature(kelvin) / adapted);
}

std::vector<ObjectId> coloured_materials(const Scene& scene) {
    const std::set<ObjectId> shown = materials_shown(scene);
    std::vector<ObjectId> coloured;
    for (const Material& material : scene.materials)
        if (material.tint != white && material.reflectance > 0.0 && shown.count(material.id) > 0)
            coloured.push_back(material.id);
    return coloured;
}

bool is_light_of_one_colour(const Scene& scene) {
    std::set<double> colours;
    for (const Luminaire& lamp : scene.luminaires) colours.insert(std::max(0.0, colour_temperature_of(scene, lamp)));
    if (std::any_of(scene.surfaces.begin(), scene.surfaces.end(), emits_by_itself)) colours.insert(0.0);
    return colours.size() <= 1;
}

bool is_neutral(const Scene& scene) { return is_light_of_one_colour(scene) && coloured_materials(scene).empty(); }

Vec3 srgb_from(const Material& material) {
    const auto [red, green, blue] = band_reflectances(material);
    return {encoded(red), encoded(green), encoded(blue)};
}

Vec3 tint_from_srgb(const Vec3& srgb, double reflectance) {
    const Vec3 shown = glm::clamp(srgb, 0.0, 1.0);
    if (shown.x == shown.y && shown.y == shown.z) return white;
    return possible_tint(of_unit_luminance({decoded(shown.x), decoded(shown.y), decoded(shown.z)}), reflectance);
}

Vec3 possible_tint(const Vec3& tint, double reflectance) {
    const double greatest = std::max({tint.x, tint.y, tint.z});
    if (!(reflectance * greatest > most_of_a_chosen_band)) return tint;
    if (reflectance >= most_of_a_chosen_band || greatest <= 1.0) return white;
    return white + (tint - white) * ((most_of_a_chosen_band / reflectance - 1.0) / (greatest - 1.0));
}

}  // namespace hanei
