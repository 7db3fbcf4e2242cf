/// The light of every group in every colour band, solved for itself at full level, and mixed.
#pragma once

#include <memory>
#include <span>
#include <vector>

namespace hanei {

/// One group's light in one band at the group's full level, one value an unknown.
struct SideLight {
    std::vector<double> direct;               ///< lx
    std::vector<double> interreflected;       ///< lx
    std::vector<double> exitance;             ///< lm/m2
    std::vector<double> exitance_half_width;  ///< lm/m2; the converged exitance lies within this of it
    std::vector<double> sent, arrived;        ///< where the next balance by the same rows may start
    double gain = 1.0;                        ///< on all light between surfaces, so that as much arrives as left
    int bounces = 0;
    bool converged = false;
    double greatest_row_sum = 0.0;
};

/// What the scene's dimmers make of it.
struct MixPart {
    double level = 1.0;        ///< of the group
    double band_weight = 1.0;  ///< of the band in what the eye sees as luminous flux
    int band = 0;
    bool of_surfaces = false;  ///< that emit by themselves
    std::shared_ptr<const SideLight> light;
};

/// Sum over all parts of the field, by luminous flux / over the parts of one band.
using LightField = std::vector<double> SideLight::*;
std::vector<double> mixed(std::span<const MixPart> parts, LightField field);
std::vector<double> mixed_band(std::span<const MixPart> parts, int band, LightField field);

}  // namespace hanei
