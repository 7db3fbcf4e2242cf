#include "ui/view/canvas.h"
#include "ui/view/frame.h"
#include "ui/view/isolux_labels.h"
#include "ui/view/language.h"
#include "ui/view/legend.h"
#include "ui/view/offscreen.h"
#include "ui/view/picture_aids.h"
#include "ui/view/value_labels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hanei {
namespace {

constexpr glm::vec3 paper{0.985F, 0.985F, 0.98F};
constexpr glm::vec3 ink_colour{0.13F, 0.14F, 0.16F};
constexpr glm::vec3 pale_ink{0.36F, 0.38F, 0.41F};

/// How a page is laid out; all in pixels.
struct Page {
    double scale = 1.0;  ///< lettering grows with pictures above 800 rows
    int caption = 0;     ///< height of the strip under the picture
    int legend = 0;      ///< width of the strip beside it
};

Page page_of(const PictureRequest& request) {
    Page page;
    page.scale = std::clamp(request.size.height / 800.0, 0.75, 6.0);
    if (!request.annotated) return page;
    if (request.has_caption) page.caption = static_cast<int>(std::lround(54.0 * page.scale));
    if (!request.has_legend) return page;
    if (request.options.shadow_classes) {
        page.legend = class_legend_width(page.scale);
    } else if (request.options.scale == Scale::false_colour)
        page.legend = legend_width(request.options, page.scale);
    return page;
}

Image drawn(Renderer& renderer, const Camera& camera, const ViewOptions& look, PixelSize size,
            const Image* room = nullptr) {
    Frame frame(size);
    renderer.draw(camera, look, Highlights{}, size, room);
    return frame.read();
}

void letter_lines(Canvas& canvas, const Solution& solution, const PictureRequest& request, PixelSize size, int x, int y,
                  double scale) {
    const TextStyle style{12.0 * scale, true, ink_colour, 2.2 * scale};
    for (const IsoluxLabel& label : isolux_labels(solution, request.camera, request.options, size, scale)) {
        canvas.text(x + label.at.x * size.width, y + label.at.y * size.height + 4.3 * scale, label.text, style,
                    Align::centre);
    }
}

/// Figures of grids and points.
void letter_values(Canvas& canvas, const Solution& solution, const PictureRequest& request, PixelSize size, int x,
                   int y, double scale) {
    constexpr glm::vec3 ground{0.985F, 0.985F, 0.98F}, line{0.13F, 0.14F, 0.16F};
    for (const ValueLabel& label : value_labels(solution, request.camera, request.options, size, scale)) {
        const Vec2 at(x + label.at.x * size.width, y + label.at.y * size.height);
        const Vec2 of(x + label.place.x * size.width, y + label.place.y * size.height);
        const Vec2 half = half_size(label, scale);
        const bool marked = label.kind != ValueLabel::Kind::figure;
        if (label.kind == ValueLabel::Kind::point) canvas.line(of.x, of.y, at.x, at.y, line, 0.8, 1.2 * scale);
        canvas.rounded(at.x - half.x, at.y - half.y, 2.0 * half.x, 2.0 * half.y, 3.0 * scale, ground,
                       marked ? 0.92 : 0.72);
        const TextStyle style{11.5 * scale, marked, ink_colour, 0.0};
        canvas.text(at.x, at.y + 4.2 * scale, label.text, style, Align::centre);
    }
}

/// All parts are shown: no single one is named.
constexpr std::string_view four_parts = "four parts";

void letter_caption(Canvas& canvas, const Solution& solution, const PictureRequest& request, const Page& page,
                    std::string_view part) {
    Caption caption = caption_of(solution, request.options);
    if (!part.empty()) caption.title = solution.scene->title + " – " + tr("Illuminance in four parts");
    if (!request.caption.empty()) {
        const std::size_t end = request.caption.find('\n');
        caption.title = request.caption.substr(0, end);
        caption.detail = end == std::string::npos ? std::string() : request.caption.substr(end + 1);
    }
    const double left = 16.0 * page.scale;
    const double top = request.size.height - page.caption;
    const double width = request.size.width - 2.0 * left;
    const TextStyle title{14.5 * page.scale, true, ink_colour, 0.0};
    const TextStyle detail{11.5 * page.scale, false, pale_ink, 0.0};
    canvas.rectangle(0.0, top, request.size.width, page.caption, paper);
    canvas.text(left, top + 23.0 * page.scale, canvas.fitted(caption.title, title, width), title);
    canvas.text(left, top + 42.0 * page.scale, canvas.fitted(caption.detail, detail, width), detail);
}

/// Legend strip and caption around what has been laid on the sheet.
void letter_page(Canvas& canvas, const Solution& solution, const PictureRequest& request, const Page& page,
                 std::string_view part = {}) {
    if (page.legend > 0) {
        const int height = request.size.height - page.caption;
        canvas.rectangle(request.size.width - page.legend, 0.0, page.legend, height, paper);
        const Image legend = request.options.shadow_classes
                                 ? class_legend_image(solution, request.options, height, page.scale)
                                 : legend_image(request.options, height, page.scale, part);
        canvas.picture(legend, request.size.width - page.legend, 0);
    }
    if (page.caption > 0) letter_caption(canvas, solution, request, page, part);
}

struct Panel {
    LightPart part;
    const char* name;
};
constexpr std::array panels{Panel{LightPart::total, "Total: direct and interreflected, with shadows"},
                            Panel{LightPart::direct, "Direct light only"},
                            Panel{LightPart::unshadowed, "Total without shadows"},
                            Panel{LightPart::interreflected, "Interreflected light only"}};

}  // namespace

PixelSize view_size(const PictureRequest& request) {
    const Page page = page_of(request);
    return {std::max(1, request.size.width - page.legend), std::max(1, request.size.height - page.caption)};
}

Image render_picture(SolutionSnapshot solution, const PictureRequest& request) {
    Renderer renderer;
    renderer.set_scene(solution->scene);
    renderer.set_solution(solution);
    const PixelSize view = view_size(request);
    const Image room =
        drawn(renderer, request.camera, request.options, view, request.exact ? &request.exact->room : nullptr);
    if (!request.annotated && !request.has_axes) return room;
    const Page page = page_of(request);
    Canvas canvas(request.size);
    canvas.fill(paper);
    canvas.picture(room, 0, 0);
    letter_aids(canvas, request, 0, 0, view, page.scale);
    if (!request.annotated) return canvas.image();
    if (!request.options.values) letter_lines(canvas, *solution, request, view, 0, 0, page.scale);
    letter_values(canvas, *solution, request, view, 0, 0, page.scale);
    letter_page(canvas, *solution, request, page);
    return canvas.image();
}

Image render_four_up(SolutionSnapshot solution, const PictureRequest& asked) {
    Renderer renderer;
    renderer.set_scene(solution->scene);
    renderer.set_solution(solution);
    const PixelSize view = view_size(asked);
    const Page page = page_of(asked);
    const int gap = static_cast<int>(std::lround(6.0 * page.scale));
    const int title = static_cast<int>(std::lround(26.0 * page.scale));
    const PixelSize size{std::max(1, (view.width - 3 * gap) / 2), std::max(1, (view.height - 2 * title - gap) / 2)};
    Canvas canvas(asked.size);
    canvas.fill(paper);
    const TextStyle heading{13.0 * page.scale, true, ink_colour, 0.0};
    const TextStyle missing{13.0 * page.scale, false, pale_ink, 2.0};
    for (std::size_t k = 0; k < panels.size(); ++k) {
        PictureRequest request = asked;
        request.options.part = panels[k].part;
        request.options.grids = false;  // panels are too small for dots
        const int x = gap + static_cast<int>(k % 2) * (size.width + gap);
        const int y = title + static_cast<int>(k / 2) * (size.height + title);
        canvas.picture(drawn(renderer, request.camera, request.options, size), x, y);
        if (k == 0) letter_aids(canvas, request, x, y, size, 0.85 * page.scale);
        canvas.text(x + 2.0, y - 8.0 * page.scale, canvas.fitted(panels[k].name, heading, size.width), heading);
        if (!has_part(*solution, panels[k].part)) {
            canvas.text(x + 0.5 * size.width, y + size.height - 12.0 * page.scale, "Not computed in this study",
                        missing, Align::centre);
        } else if (asked.annotated) {
            letter_lines(canvas, *solution, request, size, x, y, 0.85 * page.scale);
        }
    }
    if (asked.annotated) letter_page(canvas, *solution, asked, page, four_parts);
    return canvas.image();
}

}  // namespace hanei
