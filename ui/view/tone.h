/// From the light of a place to the colour of a pixel, as the picture's shader does it.
#pragma once

#include "ui/view/view_options.h"

#include <glm/vec3.hpp>

#include <vector>

namespace hanei {

/// Displayed value per cd/m2 so that the room's mean luminance comes out in the middle of the
/// picture's greys. From the total light whatever part is shown, so that pictures compare.
double automatic_exposure(const Solution& solution);

/// Linear light (0 to 1) of the three primaries, which adds up, and its sRGB encoding, which does not.
glm::vec3 encoded_srgb(const glm::vec3& linear);
glm::vec3 linear_srgb(const glm::vec3& encoded);

/// What a photograph shows of a luminance in three bands: `shown` is 1 in the middle of the greys.
/// Linear light. Each band has its own shoulder, so that bright colours fade to white as on film.
glm::vec3 photographed(const Vec3& shown);

/// Holds     what the scale needs, worked out once. Any thread may ask.
class Tone {
public:
    Tone(const Solution& solution, const ViewOptions& look, double pixel_scale = 1.0);

    /// Linear light of a place on a patch with this illuminance, in bands for photos (band_light.h).
    /// `pixel`: where it shows, from the left and from the bottom; hatching lies on the picture.
    glm::vec3 colour(double lux, const Vec3& bands, std::uint32_t patch, const Vec2& pixel = Vec2(0.0)) const;

private:
    ViewOptions options_;
    double pixel_scale_ = 1.0;
    std::vector<Vec3> reflectance_;  ///< one a patch, in three bands
    double exposure_ = 1.0;
    std::vector<double> borders_;     ///< lx, of bands
    std::vector<glm::vec3> of_band_;  ///< linear light, between borders
};

/// The lines of equal illuminance over a picture of figures.
class IsoluxLines {
public:
    IsoluxLines(const ViewOptions& options, double pixel_scale);

    struct Ink {
        glm::vec3 colour{0.0F};
        float cover = 0.0F;  ///< 0 to 1 of the pixel
    };
    /// `steepness` is the change of log(lux) across a pixel.
    Ink at(double lux, double steepness) const;

private:
    ViewOptions options_;
    std::vector<double> lines_;  ///< lx
    double width_ = 1.5;         ///< pixels
};

}  // namespace hanei
