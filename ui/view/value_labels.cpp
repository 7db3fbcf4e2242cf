#include "ui/view/value_labels.h"

#include "ui/view/value_buffer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace hanei {
namespace {

constexpr double digit_width = 6.9, text_height = 15.0, margin = 3.0;  // pixels at scale 1
constexpr int buffer_height = 300;
constexpr double in_front = 0.03, share_in_front = 0.01;  // m, of the depth: what is nearer hides a place
constexpr int least_stride = 1, greatest_stride = 32;

std::size_t letters_in(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char byte) { return (byte & 0xC0) != 0x80; }));
}

/// Where light is reported and shown of this part; empty where there is none.
std::optional<double> part_of(const PointValue& value, LightPart part) {
    if (value.inside_solid) return std::nullopt;
    switch (part) {
        case LightPart::total:
            return value.total().value;
        case LightPart::direct:
            return value.direct.value;
        case LightPart::interreflected:
            return value.interreflected.value;
        case LightPart::unshadowed:
            break;
    }
    return std::nullopt;
}

/// Two digits: more of an error would say nothing.
std::string error_text(double error) {
    return error >= 9.95 ? fmt::format("{:.0f}", error) : fmt::format("{:.2g}", error);
}

struct Rect {
    Vec2 middle{0.0}, half{0.0};
};

bool overlap(const Rect& a, const Rect& b) {
    return std::abs(a.middle.x - b.middle.x) < a.half.x + b.half.x &&
           std::abs(a.middle.y - b.middle.y) < a.half.y + b.half.y;
}

/// Places on the picture that are seen, in pixels.
class Sheet {
public:
    Sheet(const Solution& solution, const Camera& camera, const ViewOptions& look, PixelSize size)
        : camera_(camera), size_(size) {
        const double shrink = static_cast<double>(buffer_height) / size.height;
        const PixelSize small{std::max(2, static_cast<int>(std::lround(size.width * shrink))), buffer_height};
        ViewOptions plain = look;
        plain.luminaires = false;
        buffer_ = value_buffer(solution, camera, plain, small);
    }

    std::optional<Vec2> seen(const Vec3& place) const {
        const auto at = projected(camera_, place, size_.aspect());
        if (!at || at->x < 0.0 || at->y < 0.0 || at->x >= 1.0 || at->y >= 1.0) return std::nullopt;
        const Ray through = ray_through(camera_, *at, size_.aspect());
        const double depth = glm::dot(place - through.origin, axes_of(camera_).forward);
        const std::size_t pixel =
            buffer_.at(static_cast<int>(at->x * buffer_.size.width), static_cast<int>(at->y * buffer_.size.height));
        if (static_cast<double>(buffer_.depth[pixel]) < depth * (1.0 - share_in_front) - in_front) return std::nullopt;
        return Vec2(at->x * size_.width, at->y * size_.height);
    }

    bool holds(const Rect& rect) const {
        return rect.middle.x - rect.half.x >= 1.0 && rect.middle.y - rect.half.y >= 1.0 &&
               rect.middle.x + rect.half.x <= size_.width - 1.0 && rect.middle.y + rect.half.y <= size_.height - 1.0;
    }
    Vec2 share(const Vec2& pixels) const { return {pixels.x / size_.width, pixels.y / size_.height}; }

private:
    const Camera& camera_;
    PixelSize size_;
    ValueBuffer buffer_;
};

class Placer {
public:
    Placer(const Sheet& sheet, const ViewOptions& look, double scale) : sheet_(sheet), look_(look), scale_(scale) {}

    void add_point(const PointResult& point);
    void add_grid(const GridResult& grid, bool in_full);
    std::vector<ValueLabel> take() { return std::move(labels_); }

private:
    bool place(ValueLabel label, const Vec2& middle, const Vec2& of);
    bool fits(const std::vector<std::optional<Vec2>>& places, const GridResult& grid, int stride) const;

    const Sheet& sheet_;
    const ViewOptions& look_;
    double scale_;
    std::vector<ValueLabel> labels_;
    std::vector<Rect> taken_;
};

bool Placer::place(ValueLabel label, const Vec2& middle, const Vec2& of) {
    const Rect rect{middle, half_size(label, scale_)};
    const bool free = sheet_.holds(rect) && std::none_of(taken_.begin(), taken_.end(),
                                                         [&](const Rect& other) { return overlap(rect, other); });
    if (!free) return false;
    label.at = sheet_.share(middle);
    label.place = sheet_.share(of);
    taken_.push_back(rect);
    labels_.push_back(std::move(label));
    return true;
}

void Placer::add_point(const PointResult& point) {
    const auto lux = part_of(point.value, look_.part);
    const auto of = lux ? sheet_.seen(point.position) : std::nullopt;
    if (!of) return;
    const double error = point.value.error.total();
    ValueLabel label;
    label.kind = ValueLabel::Kind::point;
    label.object = point.point;
    label.text = value_text(*lux, look_);
    const std::string_view unit = name_of(look_.unit);
    label.text = error > 0.0 && error < 1e6
                     ? fmt::format("{} ± {} {}", label.text, error_text(error / lux_in(look_.unit)), unit)
                     : fmt::format("{} {}", label.text, unit);
    const Vec2 half = half_size(label, scale_);
    taken_.push_back({*of, Vec2(6.0 * scale_)});
    for (const double away : {14.0, 34.0, 60.0}) {
        for (const Vec2 side : {Vec2(1, -1), Vec2(-1, -1), Vec2(1, 1), Vec2(-1, 1)}) {
            const Vec2 middle = *of + side * (half + Vec2(away * scale_, 0.6 * away * scale_));
            if (place(label, middle, *of)) return;
        }
    }
}

/// Whether figures of every `stride`th row and column leave each other room.
bool Placer::fits(const std::vector<std::optional<Vec2>>& places, const GridResult& grid, int stride) const {
    std::vector<Rect> rects;
    for (int row = stride / 2; row < grid.rows; row += stride) {
        for (int column = stride / 2; column < grid.columns; column += stride) {
            const auto k = static_cast<std::size_t>(row * grid.columns + column);
            if (!places[k]) continue;
            ValueLabel label;
            label.text = value_text(*part_of(grid.points[k].value, look_.part), look_);
            const Rect rect{*places[k], half_size(label, scale_)};
            for (const Rect& other : rects)
                if (overlap(rect, other)) return false;
            rects.push_back(rect);
        }
    }
    return true;
}

void Placer::add_grid(const GridResult& grid, bool in_full) {
    std::vector<std::optional<Vec2>> places(grid.points.size());
    double sum = 0.0;
    std::size_t valued = 0, least = 0, greatest = 0, middle = 0;
    const auto lux_of = [&](std::size_t k) { return part_of(grid.points[k].value, look_.part); };
    for (std::size_t k = 0; k < grid.points.size(); ++k) {
        const auto lux = lux_of(k);
        if (!lux) continue;
        places[k] = sheet_.seen(grid.points[k].position);
        if (valued == 0) least = greatest = middle = k;
        if (*lux < *lux_of(least)) least = k;
        if (*lux > *lux_of(greatest)) greatest = k;
        sum += *lux;
        ++valued;
    }
    if (valued == 0) return;
    const double mean = sum / static_cast<double>(valued);
    for (std::size_t k = 0; k < grid.points.size(); ++k)
        if (lux_of(k) && std::abs(*lux_of(k) - mean) < std::abs(*lux_of(middle) - mean)) middle = k;
    const auto mark = [&](std::size_t k, ValueLabel::Kind kind, const char* word, double lux) {
        if (!places[k]) return;
        ValueLabel label{kind, {}, {}, fmt::format("{} {}", word, value_text(lux, look_)), grid.grid};
        place(std::move(label), *places[k], *places[k]);
    };
    if (valued > 1) {
        mark(least, ValueLabel::Kind::least, "min", *lux_of(least));
        mark(greatest, ValueLabel::Kind::greatest, "max", *lux_of(greatest));
        mark(middle, ValueLabel::Kind::middle, "mean", mean);
    }
    int stride = least_stride;
    while (!in_full && stride < greatest_stride && !fits(places, grid, stride)) ++stride;
    for (int row = stride / 2; row < grid.rows; row += stride) {
        for (int column = stride / 2; column < grid.columns; column += stride) {
            const auto k = static_cast<std::size_t>(row * grid.columns + column);
            if (!places[k]) continue;
            ValueLabel label{ValueLabel::Kind::figure, {}, {}, value_text(*lux_of(k), look_), grid.grid};
            place(std::move(label), *places[k], *places[k]);
        }
    }
}

}  // namespace

std::string value_text(double lux, IlluminanceUnit unit) {
    const double shown = lux / lux_in(unit), size = std::abs(shown);
    if (size >= 99.95 || size == 0.0) return fmt::format("{:.0f}", shown);
    if (size >= 9.995) return fmt::format("{:.1f}", shown);
    if (size >= 0.995) return fmt::format("{:.2f}", shown);
    return fmt::format("{:.2g}", shown);
}

std::string value_text(double lux, const ViewOptions& look) {
    const std::string text = value_text(std::abs(lux), look.unit);
    if (!look.difference || lux == 0.0) return value_text(lux, look.unit);
    return fmt::format("{}{}", lux < 0.0 ? "−" : "+", text);
}

Vec2 half_size(const ValueLabel& label, double scale) {
    const double letters = static_cast<double>(letters_in(label.text));
    return 0.5 * scale * Vec2(letters * digit_width + 2.0 * margin, text_height);
}

std::vector<ValueLabel> value_labels(const Solution& solution, const Camera& camera, const ViewOptions& look,
                                     PixelSize size, double scale) {
    const bool shown = (look.values && look.scale == Scale::false_colour && !look.shadow_classes) || look.pins;
    if (!shown || !solution.display || !solution.mesh || size.width < 2 || size.height < 2) return {};
    const Sheet sheet(solution, camera, look, size);
    Placer placer(sheet, look, scale);
    if (look.pins)
        for (const PointResult& point : solution.points) placer.add_point(point);
    if (!look.values || look.scale == Scale::photo || look.shadow_classes) return placer.take();
    for (const bool chosen : {true, false})
        for (const GridResult& grid : solution.grids)
            if ((grid.grid == look.values_of) == chosen) placer.add_grid(grid, chosen);
    return placer.take();
}

}  // namespace hanei
