#include "ui/view/legend.h"

#include "ui/view/canvas.h"
#include "ui/view/colour_scale.h"
#include "ui/view/isolux_labels.h"
#include "ui/view/language.h"
#include "ui/view/value_labels.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

constexpr glm::vec3 ink{0.13F, 0.14F, 0.16F};
constexpr glm::vec3 pale_ink{0.38F, 0.40F, 0.43F};
constexpr glm::vec3 card{0.985F, 0.985F, 0.98F};

/// All lengths in pixels at scale 1.
struct LegendLayout {
    double margin = 14.0;
    double bar_width = 20.0;
    double head = 58.0;  ///< quantity and part
    double foot = 34.0;  ///< kind of scale
    double cap = 9.0;    ///< colours beyond the ends
    double tick = 5.0;
    double apart = 15.0;  ///< base lines of tick labels
};

TextStyle head_style(double scale) { return {13.0 * scale, true, ink, 0.0}; }
TextStyle part_style(double scale) { return {11.5 * scale, false, pale_ink, 0.0}; }
TextStyle tick_style(double scale) { return {12.0 * scale, false, ink, 0.0}; }

std::string quantity_text(const ViewOptions& look) {
    return tr(look.difference ? "Difference B − A" : "Illuminance E");
}
std::string part_text(std::string_view part, IlluminanceUnit unit) {
    return fmt::format("{}, {}", tr(part), name_of(unit));
}

std::string foot_text(const ViewOptions& look) {
    return std::string(look.difference ? tr("grey: nothing there") : tr(name_of(look.steps)));
}

/// Figures to name: both ends, and of the steps between those that leave each other room, round
/// ones first (100 before 150).
std::vector<double> ticks_of(const ViewOptions& look, double bar_height, double apart) {
    const double high = look.range.high;
    if (look.difference) return {high, 0.5 * high, 0.0, -0.5 * high, -high};
    const std::vector<double> all = scale_steps(look);
    std::vector<double> ticks{look.range.high, look.range.low};
    const double unit = look.steps == ColourSteps::standard_steps ? 1.0 : lux_in(look.unit);
    for (const double digit : {1.0, 5.0, 2.0, 3.0, 1.5, 7.5, 0.0}) {
        for (auto step = all.rbegin(); step != all.rend(); ++step) {
            const double shown = *step / unit;
            const double leading = shown / std::pow(10.0, std::floor(std::log10(shown) + 1e-9));
            if (digit > 0.0 && std::abs(leading - digit) > 1e-6) continue;
            const double height = legend_position(*step, look) * bar_height;
            const bool room = std::all_of(ticks.begin(), ticks.end(), [&](double other) {
                return std::abs(legend_position(other, look) * bar_height - height) >= apart;
            });
            if (room) ticks.push_back(*step);
        }
    }
    return ticks;
}

/// What lies beyond an end of the scale, hatched as in the picture.
void draw_cap(Canvas& canvas, const ViewOptions& look, bool above, double x, double y, double width, double height) {
    canvas.rectangle(x, y, width, height, above ? colour_above : colour_below);
    if (!look.marks_clipped) return;
    for (int v = 0; v < static_cast<int>(height); ++v)
        for (int u = 0; u < static_cast<int>(width); ++u)
            if (is_striped(above, u, -v, 1.0))
                canvas.rectangle(x + u, y + v, 1.0, 1.0, above ? stripe_above : stripe_below);
}

/// From less to more, striped as in the picture.
void draw_difference_bar(Canvas& canvas, const ViewOptions& look, double x, double top, double width, int rows) {
    for (int row = 0; row < rows; ++row) {
        const double lux = lux_at(1.0 - (row + 0.5) / rows, look);
        canvas.rectangle(x, top + row, width, 1.0, colour_of(lux, look));
        for (int u = 0; u < static_cast<int>(width); ++u) {
            const glm::vec3 colour = colour_of(lux, look, u, -row, 1.0);
            if (colour != colour_of(lux, look)) canvas.rectangle(x + u, top + row, 1.0, 1.0, colour);
        }
    }
    canvas.frame(x, top, width, rows, ink, 0.35);
}

void draw_bar(Canvas& canvas, const ViewOptions& look, double x, double top, double width, double height, double cap) {
    const int rows = static_cast<int>(height);
    if (look.difference) return draw_difference_bar(canvas, look, x, top, width, rows);
    for (int row = 0; row < rows; ++row) {
        const double lux = lux_at(1.0 - (row + 0.5) / rows, look);
        canvas.rectangle(x, top + row, width, 1.0, colour_of(lux, look));
    }
    draw_cap(canvas, look, true, x, top - cap - 2.0, width, cap);
    draw_cap(canvas, look, false, x, top + rows + 2.0, width, cap);
    canvas.frame(x, top - cap - 2.0, width, cap, ink, 0.35);
    canvas.frame(x, top + rows + 2.0, width, cap, ink, 0.35);
    canvas.frame(x, top, width, rows, ink, 0.35);
}

void draw_isolux_marks(Canvas& canvas, const ViewOptions& look, double x, double top, double width, int rows) {
    if (!look.isolux || look.difference) return;
    for (const double step : isolux_levels(look)) {
        const double position = legend_position(step, look);
        const double y = top + (1.0 - position) * rows;
        if (position > 0.0 && position < 1.0) {
            canvas.line(x + 1.0, y, x + width - 1.0, y, glm::vec3(position < 0.5 ? 1.0F : 0.0F), 0.45);
        }
    }
}

}  // namespace

int legend_width(const ViewOptions& look, double scale) {
    const LegendLayout layout;
    Canvas measure({1, 1});
    double wide = std::max(
        measure.width_of(quantity_text(look), head_style(scale)),
        measure.width_of(part_text(name_of(LightPart::interreflected), IlluminanceUnit::lux), part_style(scale)));
    wide = std::max(wide, measure.width_of(std::string(tr(name_of(ColourSteps::standard_steps))), part_style(scale)));
    return static_cast<int>(std::ceil(wide + 2.0 * layout.margin * scale));
}

Image legend_image(const ViewOptions& look, int height_px, double scale, std::string_view part) {
    const LegendLayout layout;
    const int height = std::max(height_px, static_cast<int>(160.0 * scale));
    const int width = legend_width(look, scale);
    Canvas canvas({width, height});
    canvas.rounded(0.0, 0.0, width, height, 7.0 * scale, card, 0.94);

    const double left = layout.margin * scale;
    canvas.text(left, 24.0 * scale, quantity_text(look), head_style(scale));
    canvas.text(left, 41.0 * scale, part_text(part.empty() ? name_of(look.part) : part, look.unit), part_style(scale));
    canvas.text(left, height - 13.0 * scale, foot_text(look), part_style(scale));

    const double cap = std::round(layout.cap * scale);
    const double top = std::round(layout.head * scale + cap + 2.0);
    const double bar_width = std::round(layout.bar_width * scale);
    const int rows = static_cast<int>(height - layout.foot * scale - cap - 2.0 - top);
    draw_bar(canvas, look, left, top, bar_width, rows, cap);
    draw_isolux_marks(canvas, look, left, top, bar_width, rows);

    for (const double lux : ticks_of(look, rows, layout.apart * scale)) {
        const double y = top + (1.0 - legend_position(lux, look)) * rows;
        const double end = left + bar_width;
        canvas.line(end + 1.0, y, end + layout.tick * scale, y, ink, 0.6);
        canvas.text(end + (layout.tick + 5.0) * scale, y + 4.3 * scale,
                    look.difference ? value_text(lux, look) : lux_text(lux, look.unit), tick_style(scale));
    }
    return canvas.image();
}

}  // namespace hanei
