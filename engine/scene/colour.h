/// Colour in three bands: the primaries of linear sRGB, each in units of luminous flux.
///
/// Light is three numbers whose luminance-weighted mean is the photometric figure: an illuminance of
/// 500 lx in the bands {500, 500, 500} is white, {1000, 400, 20} is 500 lx of orange light. White is
/// what pictures show as white; a scene without colour needs one band, since all three are equal.
#pragma once

#include "engine/scene/scene.h"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace hanei {

inline constexpr int colour_bands = 3;

/// What each primary adds to the luminance (Y of IEC 61966-2-1); they add up to 1.
inline constexpr Vec3 luminance_weights{0.2126, 0.7152, 0.0722};

/// The photometric figure of a figure in three bands: lx of an illuminance, 1 of a tint.
double luminance(const Vec3& bands);

/// A tint's luminance may differ from 1 by this, so that one written with four digits is one.
inline constexpr double tint_tolerance = 1e-3;

/// Colour temperatures a lamp may have, K. Below there is no primary but red, above no daylight.
inline constexpr double lowest_colour_temperature = 1000.0;
inline constexpr double highest_colour_temperature = 25000.0;

/// Reflectance x tint.
///
/// Returns   three numbers from 0 to 1; for a material without tint its reflectance, to the bit.
std::array<double, 3> band_reflectances(const Material& material);

/// The colour of light of a temperature, for eyes adapted to sRGB's white: the black body below
/// 4000 K (chromaticity by Krystek, Color Res. Appl. 10, 1985, within 2e-4 in u and v), a phase of
/// daylight above 5000 K (CIE 15:2018, 4.1.2), between them a mixture in shares of the temperature,
/// so that there is no jump. Outside the triangle of sRGB a negative primary is 0.
///
/// Needs     a temperature in the range above; one outside is taken as its nearer end.
/// Returns   three bands, 0 or more, whose luminance is 1. 6504 K is white within 1e-3.
Vec3 light_of_temperature(double kelvin);

/// The keyword under which a container states the temperature of an emitter's light, as "3000 K".
inline constexpr std::string_view colour_temperature_keyword = "GLDF colour temperature";

/// The colour temperature, K, that a luminaire file states in plain figures ("3000", "3000 K") for the
/// lamps in use; nothing where it says it otherwise ("nw", "830"), or one that lamps cannot have.
std::optional<double> stated_colour_temperature(const Photometry& photometry);

/// The colour that the project's pictures show as white. Neutral light is sRGB's white: with a neutral
/// lamp, or a surface that emits by itself, it is {1, 1, 1}. Where every lamp has a temperature, eyes
/// and cameras adapt to the lamps: it is the light of the mean of their reciprocal temperatures
/// (mired), each lamp counting alike however it is dimmed, so that dimming changes no colour.
Vec3 reference_white(const Scene& scene);

/// How a luminaire's output divides over the bands: its light's colour relative to reference_white,
/// band by band (von Kries). Multiply its flux, intensity or illuminance by it.
///
/// Returns   three bands, 0 or more, whose luminance is 1; {1, 1, 1}, to the bit, for a neutral lamp
///           and where all lamps of the scene have one colour.
/// Weak when the white has hardly any blue (below 2000 K): it is taken to have 0.02 of it.
/// Cost      a look at all luminaires and free surfaces.
Vec3 band_output(const Luminaire& luminaire, const Scene& scene);

/// Materials that give light a colour: some face or sub-area is covered with them, they reflect
/// something and their tint is not white. In the order of the scene's materials.
std::vector<ObjectId> coloured_materials(const Scene& scene);

/// Whether every light, lamp or surface that emits by itself, has the same colour.
bool is_light_of_one_colour(const Scene& scene);

/// Whether one band stands for three: light of one colour and no coloured material.
bool is_neutral(const Scene& scene);

/// The colour of a material as sRGB shows it beside white paper of reflectance 1: encoded, 0 to 1.
Vec3 srgb_from(const Material& material);

/// No band of a colour chosen on screen reflects more than this, as no paint does: a band that loses
/// nothing would leave interreflection without a bound in advance. Files may state up to 1.
inline constexpr double most_of_a_chosen_band = 0.95;

/// The tint of a colour chosen on screen (encoded sRGB), whose lightness is left to the reflectance.
/// Black and greys are {1, 1, 1}. A colour more saturated than a surface of this luminous reflectance
/// can be is drawn towards white until no band reflects too much.
Vec3 tint_from_srgb(const Vec3& srgb, double reflectance);

/// The tint drawn towards white as far as `reflectance` needs it.
Vec3 possible_tint(const Vec3& tint, double reflectance);

}  // namespace hanei
