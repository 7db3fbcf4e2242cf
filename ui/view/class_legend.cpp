#include "engine/scene/faces.h"
#include "ui/view/canvas.h"
#include "ui/view/class_colours.h"
#include "ui/view/language.h"
#include "ui/view/legend.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

constexpr glm::vec3 ink{0.13F, 0.14F, 0.16F};
constexpr glm::vec3 pale_ink{0.38F, 0.40F, 0.43F};
constexpr glm::vec3 card{0.985F, 0.985F, 0.98F};
constexpr double margin = 14.0;  // all lengths in pixels at scale 1
constexpr double swatch = 20.0;
constexpr double row_height = 58.0;
constexpr double head = 66.0;

TextStyle head_style(double scale) { return {13.0 * scale, true, ink, 0.0}; }
TextStyle name_style(double scale) { return {12.0 * scale, false, ink, 0.0}; }
TextStyle small_style(double scale) { return {11.0 * scale, false, pale_ink, 0.0}; }

/// The hatching of the picture, across a square.
void hatch(Canvas& canvas, double x, double y, double size, double scale) {
    const double step = hatching_px * std::sqrt(2.0) * scale;
    for (double at = 0.5 * step; at < 2.0 * size; at += step) {
        const double over = std::max(0.0, at - size), under = std::min(at, size);
        canvas.line(x + over, y + under, x + under, y + over, hatching_colour, 1.0, 1.6 * scale);
    }
}

void draw_row(Canvas& canvas, const ClassRow& row, double y, double scale) {
    const double x = margin * scale, size = swatch * scale;
    canvas.rectangle(x, y, size, size, class_colours[static_cast<std::size_t>(row.kind)]);
    if (row.kind == LightClass::partly) hatch(canvas, x, y, size, scale);
    canvas.frame(x, y, size, size, ink, 0.45);
    const std::size_t comma = row.counts.find(", ");
    canvas.text(x + size + 8.0 * scale, y + 9.0 * scale, row.name, name_style(scale));
    canvas.text(x + size + 8.0 * scale, y + 23.0 * scale, row.counts.substr(0, comma), small_style(scale));
    if (comma != std::string::npos)
        canvas.text(x + size + 8.0 * scale, y + 37.0 * scale, row.counts.substr(comma + 2), small_style(scale));
}

void draw_line_key(Canvas& canvas, double y, double scale) {
    const double x = margin * scale, end = x + 30.0 * scale;
    canvas.line(x, y, end, y, ink, 1.0, 2.0 * scale);
    for (double at = x; at < end; at += 9.0 * scale)
        canvas.line(at, y + 20.0 * scale, std::min(end, at + 5.4 * scale), y + 20.0 * scale, ink, 1.0, 1.5 * scale);
    canvas.text(end + 8.0 * scale, y + 4.0 * scale, tr("umbra"), name_style(scale));
    canvas.text(end + 8.0 * scale, y + 24.0 * scale, tr("penumbra"), name_style(scale));
}

}  // namespace

std::string shadows_of_text(const Scene& scene, ObjectId luminaire) {
    for (std::size_t k = 0; k < scene.luminaires.size(); ++k) {
        const Luminaire& each = scene.luminaires[k];
        if (each.id == luminaire) return each.name.empty() ? say("luminaire {}", k + 1) : each.name;
    }
    return tr(scene.luminaires.size() == 1 ? "one luminaire" : "all luminaires");
}

std::string_view outline_text() {
    return tr("Solid: umbra of single bodies, where several together can hide more. Dashed: penumbra");
}

std::vector<ClassRow> class_rows(const Solution* solution, const ViewOptions& look) {
    std::vector<ClassRow> rows{{LightClass::lit, tr("Lit"), {}},
                               {LightClass::partly, tr("Partly lit"), {}},
                               {LightClass::umbra, tr("In umbra"), {}},
                               {LightClass::away, tr("Faces away"), {}}};
    if (solution == nullptr || solution->shadows == nullptr) return rows;
    const Mesh& mesh = *solution->mesh;
    const auto shares = class_shares(mesh, patch_classes(*solution->shadows, look.shadows_of, mesh.patches.size()));
    for (ClassRow& row : rows) {
        const ClassShare& share = shares[static_cast<std::size_t>(row.kind)];
        row.counts = say(share.patches == 1 ? "{} patch, {:.{}f} m²" : "{} patches, {:.{}f} m²", share.patches,
                         share.area, share.area < 9.95 ? 1 : 0);
    }
    return rows;
}

int class_legend_width(double scale) {
    Canvas measure({1, 1});
    const double wide = std::max(measure.width_of(tr("Shadow classes"), head_style(scale)),
                                 swatch * scale + 8.0 * scale + measure.width_of("00000 patches", small_style(scale)));
    return static_cast<int>(std::ceil(wide + 2.0 * margin * scale));
}

Image class_legend_image(const Solution& solution, const ViewOptions& look, int height_px, double scale) {
    const int width = class_legend_width(scale);
    Canvas canvas({width, height_px});
    canvas.rounded(0.0, 0.0, width, height_px, 7.0 * scale, card, 0.94);
    const double left = margin * scale, room = width - 2.0 * left;
    canvas.text(left, 24.0 * scale, tr("Shadow classes"), head_style(scale));
    const TextStyle quiet = small_style(scale);
    canvas.text(left, 41.0 * scale, canvas.fitted(shadows_of_text(*solution.scene, look.shadows_of), quiet, room),
                quiet);
    double y = head * scale;
    for (const ClassRow& row : class_rows(&solution, look)) {
        draw_row(canvas, row, y, scale);
        y += row_height * scale;
    }
    if (look.shadow_outlines) draw_line_key(canvas, y + 6.0 * scale, scale);
    return canvas.image();
}

}  // namespace hanei
