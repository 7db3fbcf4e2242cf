#include "ui/view/canvas.h"

#include "engine/base/check.h"
#include "ui/view/japanese_fonts.h"

#include <algorithm>
#include <cstring>
#include <numbers>
#include <string_view>
#include <vector>

namespace hanei {
namespace {

void colour(cairo_t* cairo, const glm::vec3& rgb, double opacity) {
    cairo_set_source_rgba(cairo, static_cast<double>(rgb.x), static_cast<double>(rgb.y), static_cast<double>(rgb.z),
                          opacity);
}

std::uint32_t read_pixel(const unsigned char* row, int x) {
    std::uint32_t pixel = 0;
    std::memcpy(&pixel, row + 4 * x, 4);
    return pixel;
}

/// Cairo keeps colours multiplied by their opacity.
std::uint8_t unmultiplied(std::uint32_t value, std::uint32_t alpha) {
    if (alpha == 0) return 0;
    return static_cast<std::uint8_t>(std::min<std::uint32_t>(255, (value * 255 + alpha / 2) / alpha));
}

/// A stretch of a text for which one font has the letters.
struct TextPart {
    std::string text;
    bool eastern = false;
};

std::vector<TextPart> parts_of(std::string_view text) {
    if (japanese_font() == nullptr) return {{std::string(text), false}};
    std::vector<TextPart> parts;
    while (!text.empty()) {
        const Letter letter = first_letter(text);
        const bool eastern = is_eastern(letter.code);
        if (parts.empty() || parts.back().eastern != eastern) parts.push_back({"", eastern});
        parts.back().text += text.substr(0, letter.bytes);
        text.remove_prefix(letter.bytes);
    }
    return parts;
}

}  // namespace

Canvas::Canvas(PixelSize size)
    : size_(size),
      surface_(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, size.width, size.height), cairo_surface_destroy),
      cairo_(cairo_create(surface_.get()), cairo_destroy) {
    HANEI_CHECK(cairo_surface_status(surface_.get()) == CAIRO_STATUS_SUCCESS);
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(cairo_.get(), options);
    cairo_font_options_destroy(options);
}

void Canvas::fill(const glm::vec3& rgb, double opacity) {
    colour(cairo_.get(), rgb, opacity);
    cairo_paint(cairo_.get());
}

void Canvas::rectangle(double x, double y, double width, double height, const glm::vec3& rgb, double opacity) {
    colour(cairo_.get(), rgb, opacity);
    cairo_rectangle(cairo_.get(), x, y, width, height);
    cairo_fill(cairo_.get());
}

void Canvas::rounded(double x, double y, double width, double height, double radius, const glm::vec3& rgb,
                     double opacity) {
    constexpr double quarter = 0.5 * std::numbers::pi;
    cairo_t* cairo = cairo_.get();
    cairo_new_sub_path(cairo);
    cairo_arc(cairo, x + width - radius, y + radius, radius, -quarter, 0.0);
    cairo_arc(cairo, x + width - radius, y + height - radius, radius, 0.0, quarter);
    cairo_arc(cairo, x + radius, y + height - radius, radius, quarter, 2.0 * quarter);
    cairo_arc(cairo, x + radius, y + radius, radius, 2.0 * quarter, 3.0 * quarter);
    cairo_close_path(cairo);
    colour(cairo, rgb, opacity);
    cairo_fill(cairo);
}

void Canvas::frame(double x, double y, double width, double height, const glm::vec3& rgb, double opacity) {
    colour(cairo_.get(), rgb, opacity);
    cairo_set_line_width(cairo_.get(), 1.0);
    cairo_rectangle(cairo_.get(), x + 0.5, y + 0.5, width - 1.0, height - 1.0);
    cairo_stroke(cairo_.get());
}

void Canvas::line(double x0, double y0, double x1, double y1, const glm::vec3& rgb, double opacity, double width) {
    colour(cairo_.get(), rgb, opacity);
    cairo_set_line_width(cairo_.get(), width);
    cairo_move_to(cairo_.get(), x0, y0);
    cairo_line_to(cairo_.get(), x1, y1);
    cairo_stroke(cairo_.get());
}

void Canvas::picture(const Image& image, int x, int y) {
    std::vector<std::uint32_t> pixels;
    for (std::size_t k = 0; k < image.rgba.size(); k += 4) {
        const std::uint32_t alpha = image.rgba[k + 3];
        const auto part = [&](std::size_t channel) { return (image.rgba[k + channel] * alpha + 127U) / 255U; };
        pixels.push_back(alpha << 24 | part(0) << 16 | part(1) << 8 | part(2));
    }
    const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> sheet(
        cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(pixels.data()), CAIRO_FORMAT_ARGB32,
                                            image.width, image.height, 4 * image.width),
        cairo_surface_destroy);
    cairo_set_source_surface(cairo_.get(), sheet.get(), x, y);
    cairo_rectangle(cairo_.get(), x, y, image.width, image.height);
    cairo_fill(cairo_.get());
    colour(cairo_.get(), glm::vec3(0.0F), 1.0);  // the sheet may go before this canvas
}

void Canvas::choose(const TextStyle& style, bool eastern) {
    cairo_select_font_face(cairo_.get(), eastern ? japanese_font()->name : "Inter", CAIRO_FONT_SLANT_NORMAL,
                           style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_.get(), style.size);
}

double Canvas::width_of(const std::string& text, const TextStyle& style) {
    double width = 0.0;
    for (const auto& [part, eastern] : parts_of(text)) {
        choose(style, eastern);
        cairo_text_extents_t extents;
        cairo_text_extents(cairo_.get(), part.c_str(), &extents);
        width += extents.x_advance;
    }
    return width;
}

void Canvas::text(double x, double y, const std::string& text, const TextStyle& style, Align align) {
    const double width = width_of(text, style);
    const double start = align == Align::left ? x : align == Align::centre ? x - 0.5 * width : x - width;
    cairo_t* cairo = cairo_.get();
    cairo_move_to(cairo, start, y);
    for (const auto& [part, eastern] : parts_of(text)) {
        choose(style, eastern);
        cairo_text_path(cairo, part.c_str());
    }
    if (style.halo > 0.0) {
        colour(cairo, glm::vec3(1.0F), 0.85);
        cairo_set_line_width(cairo, 2.0 * style.halo);
        cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
        cairo_stroke_preserve(cairo);
    }
    colour(cairo, style.colour, 1.0);
    cairo_fill(cairo);
}

std::string Canvas::fitted(const std::string& text, const TextStyle& style, double width) {
    if (width_of(text, style) <= width) return text;
    std::string cut = text;
    while (!cut.empty() && width_of(cut + "…", style) > width) {
        // A UTF-8 letter goes as a whole: its continuation bytes first, then its leading byte.
        while (cut.size() > 1 && (static_cast<unsigned char>(cut.back()) & 0xC0U) == 0x80U) cut.pop_back();
        cut.pop_back();
    }
    return cut + "…";
}

Image Canvas::image() const {
    cairo_surface_flush(surface_.get());
    const unsigned char* data = cairo_image_surface_get_data(surface_.get());
    const int stride = cairo_image_surface_get_stride(surface_.get());
    Image image{size_.width, size_.height, {}};
    image.rgba.reserve(static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height) * 4);
    for (int y = 0; y < size_.height; ++y) {
        for (int x = 0; x < size_.width; ++x) {
            const std::uint32_t pixel = read_pixel(data + static_cast<std::ptrdiff_t>(y) * stride, x);
            const std::uint32_t alpha = pixel >> 24;
            image.rgba.push_back(unmultiplied((pixel >> 16) & 0xffU, alpha));
            image.rgba.push_back(unmultiplied((pixel >> 8) & 0xffU, alpha));
            image.rgba.push_back(unmultiplied(pixel & 0xffU, alpha));
            image.rgba.push_back(static_cast<std::uint8_t>(alpha));
        }
    }
    return image;
}

}  // namespace hanei
