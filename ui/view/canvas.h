/// A sheet to letter and to lay pictures on, by cairo.
#pragma once

#include "ui/view/image.h"
#include "ui/view/picture_size.h"

#include <glm/vec3.hpp>

#include <cairo.h>
#include <memory>
#include <string>

namespace hanei {

struct TextStyle {
    double size = 12.0;  ///< pixels
    bool bold = false;
    glm::vec3 colour{0.13F, 0.14F, 0.16F};
    double halo = 0.0;  ///< pixels of white around the letters
};

enum class Align { left, centre, right };

/// Lettered in Inter where it is installed, else in the system's sans serif, Japanese in the font of
/// japanese_fonts.h; grey antialiasing and
/// no hinting, so that a picture has the same bytes on every run.
class Canvas {
public:
    explicit Canvas(PixelSize size);  ///< transparent

    void fill(const glm::vec3& colour, double opacity = 1.0);
    void rectangle(double x, double y, double width, double height, const glm::vec3& colour, double opacity = 1.0);
    void rounded(double x, double y, double width, double height, double radius, const glm::vec3& colour,
                 double opacity);
    void frame(double x, double y, double width, double height, const glm::vec3& colour, double opacity);
    void line(double x0, double y0, double x1, double y1, const glm::vec3& colour, double opacity, double width = 1.0);
    void picture(const Image& image, int x, int y);  ///< laid over, by its opacity

    /// `y` is the base line.
    void text(double x, double y, const std::string& text, const TextStyle& style, Align align = Align::left);
    double width_of(const std::string& text, const TextStyle& style);
    /// The text, cut with an ellipsis so that it fits.
    std::string fitted(const std::string& text, const TextStyle& style, double width);

    Image image() const;

private:
    void choose(const TextStyle& style, bool eastern);
    PixelSize size_;
    std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface_;
    std::unique_ptr<cairo_t, void (*)(cairo_t*)> cairo_;
};

}  // namespace hanei
