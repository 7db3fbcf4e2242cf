#include "ui/view/picture_aids.h"

#include "ui/view/axis_cross.h"
#include "ui/view/scale_bar.h"

#include <algorithm>
#include <string>

namespace hanei {
namespace {

constexpr glm::vec3 card{0.985F, 0.985F, 0.98F}, ink{0.13F, 0.14F, 0.16F};
constexpr double longest_bar = 150.0;  // pixels at scale 1

glm::vec3 colour_of_axis(int axis) {
    return axis == 0   ? glm::vec3(0.76F, 0.18F, 0.16F)
           : axis == 1 ? glm::vec3(0.18F, 0.5F, 0.14F)
                       : glm::vec3(0.12F, 0.36F, 0.78F);
}

void letter_bar(Canvas& canvas, const ScaleBar& bar, double left, double middle, double scale) {
    const TextStyle style{12.0 * scale, false, ink, 0.0};
    const double thick = 5.0 * scale, text = canvas.width_of(bar.text, style), gap = 8.0 * scale;
    canvas.rounded(left - gap, middle - 11.0 * scale, bar.pixels + text + 3.0 * gap, 22.0 * scale, 4.0 * scale, card,
                   0.88);
    const double field = bar.pixels / bar.fields;
    for (int k = 0; k < bar.fields; k += 2) canvas.rectangle(left + k * field, middle - 0.5 * thick, field, thick, ink);
    canvas.frame(left, middle - 0.5 * thick, bar.pixels, thick, ink, 1.0);
    canvas.text(left + bar.pixels + gap, middle + 4.2 * scale, bar.text, style);
}

void letter_axes(Canvas& canvas, const Camera& camera, double x, double y, double scale) {
    const double arm = 26.0 * scale;
    for (const AxisMark& mark : axis_marks(camera)) {
        const Vec2 end = Vec2(x, y) + arm * mark.at;
        if (!mark.ahead) continue;
        const glm::vec3 colour = colour_of_axis(mark.axis);
        canvas.line(x, y, end.x, end.y, colour, 1.0, 2.0 * scale);
        const TextStyle style{12.5 * scale, true, colour, 2.5 * scale};
        const Vec2 letter = Vec2(x, y) + 1.3 * arm * mark.at;
        canvas.text(letter.x, letter.y + 4.4 * scale, std::string(1, mark.letter()), style, Align::centre);
    }
}

}  // namespace

void letter_aids(Canvas& canvas, const PictureRequest& request, int left, int top, PixelSize view, double scale) {
    const double low = top + view.height - 24.0 * scale;
    if (request.annotated && request.has_scale_bar) {
        const double most = std::min(longest_bar * scale, 0.4 * view.width);
        if (const auto bar = scale_bar(request.camera, view.height, most, request.length))
            letter_bar(canvas, *bar, left + 20.0 * scale, low, scale);
    }
    if (request.has_axes)
        letter_axes(canvas, request.camera, left + view.width - 48.0 * scale, top + view.height - 48.0 * scale, scale);
}

}  // namespace hanei
