#include "ui/view/exact_picture.h"

#include "engine/base/check.h"
#include "engine/base/tiles.h"
#include "ui/view/band_light.h"
#include "ui/view/pixel_tiles.h"
#include "ui/view/sight.h"
#include "ui/view/surface_light.h"
#include "ui/view/tone.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace hanei {
namespace {

constexpr float visible_step = 6.0F / 255.0F;  // between pixels of one face: less is a slope, not an edge
constexpr float visible_edge = 1.5F / 255.0F;  // between faces
constexpr double usual_height = 900.0;         // rows of a picture for which line widths are meant
constexpr std::size_t pixels_at_once = 64;     // with extra rays: between them the wish to stop is heard
constexpr double expected_share = 0.15;        // of pixels with extra rays, for the progress

/// Places of rays in a pixel, 0..1: every one in a row and in a column of its own.
std::vector<Vec2> ray_pattern(int count) {
    std::vector<Vec2> places;
    for (int k = 0; k < count; ++k) {
        double mirrored = 0.0, digit = 0.5;
        for (int rest = k; rest > 0; rest /= 2, digit *= 0.5) mirrored += digit * (rest % 2);
        places.emplace_back((k + 0.5) / count, mirrored + 0.5 / count);
    }
    return places;
}

/// A fixed texture of -0.5 to 0.5 that hides the steps of eight bits on evenly lit walls
/// (interleaved gradient noise: no pattern of its own is seen in it).
float grain(int x, int y) {
    const double inner = 0.06711056 * x + 0.00583715 * y;
    const double outer = 52.9829189 * (inner - std::floor(inner));
    return static_cast<float>(outer - std::floor(outer) - 0.5);
}

/// Of two encoded colours, by how much the eye makes of each primary.
float difference(const glm::vec3& a, const glm::vec3& b) {
    return glm::dot(glm::abs(a - b), glm::vec3(0.3F, 0.6F, 0.1F));
}

class Painter {
public:
    Painter(const Solution& solution, const DirectLight& direct, const ExactRequest& request)
        : request_(request),
          solution_(solution),
          tone_(solution, request.options, std::max(0.6, request.size.height / usual_height)),
          sight_(solution, request.camera, request.size.aspect()),
          light_(solution, direct, request.options.part),
          lines_(request.options, std::max(0.6, request.size.height / usual_height)),
          tiles_(request.size),
          pattern_(ray_pattern(request.samples)) {
        ValueBuffer& values = made_.values;
        const std::size_t pixels =
            static_cast<std::size_t>(request.size.width) * static_cast<std::size_t>(request.size.height);
        values.size = request.size;
        values.lux.assign(pixels, 0.0F);
        values.depth.assign(pixels, std::numeric_limits<float>::infinity());
        values.face.assign(pixels, ValueBuffer::nothing);
        centre_.assign(pixels, glm::vec3(0.0F));
        made_.room = {request.size.width, request.size.height, std::vector<std::uint8_t>(4 * pixels)};
    }

    bool paint(const Work& work);
    ExactPicture take() { return std::move(made_); }

private:
    /// What one ray found.
    struct Shade {
        std::optional<Seen> seen;
        double lux = 0.0;
        glm::vec3 colour{0.0F};  ///< linear light
    };
    std::vector<Shade> shaded(std::span<const Vec2> places) const;

    void look_at_centres(std::size_t tile);
    std::vector<std::size_t> edges_of(std::size_t tile) const;
    bool is_edge(int x, int y) const;
    bool refine(std::span<const std::size_t> pixels, const std::stop_token& stop);
    void write_tile(std::size_t tile);
    void write(std::size_t pixel, const glm::vec3& colour, float cover);
    double steepness_at(int x, int y) const;

    int x_of(std::size_t pixel) const {
        return static_cast<int>(pixel % static_cast<std::size_t>(request_.size.width));
    }
    int y_of(std::size_t pixel) const {
        return static_cast<int>(pixel / static_cast<std::size_t>(request_.size.width));
    }

    const ExactRequest& request_;
    const Solution& solution_;
    Tone tone_;
    Sight sight_;
    SurfaceLight light_;
    IsoluxLines lines_;
    PixelTiles tiles_;
    std::vector<Vec2> pattern_;
    ExactPicture made_;
    std::vector<glm::vec3> centre_;  ///< colours of the pixels' centres, encoded
};

std::vector<Painter::Shade> Painter::shaded(std::span<const Vec2> places) const {
    std::vector<Shade> shades(places.size());
    std::vector<std::uint32_t> met;
    for (std::uint32_t k = 0; k < places.size(); ++k) {
        shades[k].seen = sight_.through(places[k]);
        if (shades[k].seen) met.push_back(k);
    }
    const auto face_of = [&](std::uint32_t k) { return solution_.display->cells[shades[k].seen->cell].face; };
    std::stable_sort(met.begin(), met.end(), [&](auto a, auto b) { return face_of(a) < face_of(b); });
    std::vector<Seen> of_face;
    for (std::size_t begin = 0, end = 0; begin < met.size(); begin = end) {
        of_face.clear();
        for (; end < met.size() && face_of(met[end]) == face_of(met[begin]); ++end)
            of_face.push_back(*shades[met[end]].seen);
        const std::vector<double> lux = light_.at(of_face, sight_);
        for (std::size_t k = begin; k < end; ++k) {
            Shade& shade = shades[met[k]];
            shade.lux = lux[k - begin];
            const DisplayCell& cell = solution_.display->cells[shade.seen->cell];
            const Vec3 bands = bands_at(*solution_.display, cell, shade.seen->at, shade.lux);
            const Vec2 pixel{places[met[k]].x * request_.size.width, (1.0 - places[met[k]].y) * request_.size.height};
            shade.colour = tone_.colour(shade.lux, bands, cell.patch, pixel);
        }
    }
    return shades;
}

void Painter::look_at_centres(std::size_t tile) {
    const std::vector<std::size_t> pixels = tiles_.pixels(tile);
    std::vector<Vec2> places;
    for (const std::size_t pixel : pixels)
        places.emplace_back((x_of(pixel) + 0.5) / request_.size.width, (y_of(pixel) + 0.5) / request_.size.height);
    const std::vector<Shade> shades = shaded(places);
    ValueBuffer& values = made_.values;
    for (std::size_t k = 0; k < pixels.size(); ++k) {
        if (!shades[k].seen) continue;
        values.lux[pixels[k]] = static_cast<float>(shades[k].lux);
        values.depth[pixels[k]] = static_cast<float>(shades[k].seen->depth);
        values.face[pixels[k]] = static_cast<int>(solution_.display->cells[shades[k].seen->cell].face);
        centre_[pixels[k]] = encoded_srgb(shades[k].colour);
    }
}

bool Painter::is_edge(int x, int y) const {
    const ValueBuffer& values = made_.values;
    const std::size_t here = values.at(x, y);
    for (int v = std::max(0, y - 1); v <= std::min(request_.size.height - 1, y + 1); ++v) {
        for (int u = std::max(0, x - 1); u <= std::min(request_.size.width - 1, x + 1); ++u) {
            const std::size_t there = values.at(u, v);
            const bool ends = (values.face[here] < 0) != (values.face[there] < 0);
            const float allowed = values.face[here] == values.face[there] ? visible_step : visible_edge;
            if (ends || difference(centre_[here], centre_[there]) > allowed) return true;
        }
    }
    return false;
}

std::vector<std::size_t> Painter::edges_of(std::size_t tile) const {
    std::vector<std::size_t> edges = tiles_.pixels(tile);
    std::erase_if(edges, [&](std::size_t pixel) { return !is_edge(x_of(pixel), y_of(pixel)); });
    return edges;
}

bool Painter::refine(std::span<const std::size_t> pixels, const std::stop_token& stop) {
    std::vector<Vec2> places;
    for (; !pixels.empty(); pixels = pixels.subspan(std::min(pixels_at_once, pixels.size()))) {
        if (stop.stop_requested()) return false;
        const auto some = pixels.first(std::min(pixels_at_once, pixels.size()));
        places.clear();
        for (const std::size_t pixel : some) {
            for (const Vec2& at : pattern_)
                places.emplace_back((x_of(pixel) + at.x) / request_.size.width,
                                    (y_of(pixel) + at.y) / request_.size.height);
        }
        const std::vector<Shade> shades = shaded(places);
        for (std::size_t k = 0; k < some.size(); ++k) {
            glm::vec3 sum(0.0F);
            float met = 0.0F;
            for (std::size_t ray = k * pattern_.size(); ray < (k + 1) * pattern_.size(); ++ray) {
                sum += shades[ray].colour;
                met += shades[ray].seen ? 1.0F : 0.0F;
            }
            const glm::vec3 mean = met > 0.0F ? encoded_srgb(sum / met) : glm::vec3(0.0F);
            write(some[k], mean, met / static_cast<float>(pattern_.size()));
        }
    }
    return true;
}

void Painter::write_tile(std::size_t tile) {
    for (const std::size_t pixel : tiles_.pixels(tile))
        write(pixel, centre_[pixel], made_.values.face[pixel] < 0 ? 0.0F : 1.0F);
}

/// Change of log(lux) across the pixel, along the neighbours on the same face.
double Painter::steepness_at(int x, int y) const {
    const ValueBuffer& values = made_.values;
    const std::size_t here = values.at(x, y);
    const auto log_lux = [&](std::size_t pixel) {
        return std::log(std::max(static_cast<double>(values.lux[pixel]), 1e-3));
    };
    const auto slope = [&](int dx, int dy) {
        double rise = 0.0;
        int steps = 0;
        for (const int side : {-1, 1}) {
            const int u = x + side * dx, v = y + side * dy;
            if (u < 0 || v < 0 || u >= request_.size.width || v >= request_.size.height) continue;
            const std::size_t there = values.at(u, v);
            if (values.face[there] != values.face[here]) continue;
            rise += side * (log_lux(there) - log_lux(here));
            ++steps;
        }
        return steps > 0 ? rise / steps : 0.0;
    };
    return std::hypot(slope(1, 0), slope(0, 1));
}

void Painter::write(std::size_t pixel, const glm::vec3& colour, float cover) {
    const int x = x_of(pixel), y = y_of(pixel);
    glm::vec3 shown = colour;
    if (request_.options.scale == Scale::photo) {
        shown += grain(x, y) / 255.0F;
    } else if (request_.options.isolux && made_.values.face[pixel] >= 0) {
        const IsoluxLines::Ink ink = lines_.at(static_cast<double>(made_.values.lux[pixel]), steepness_at(x, y));
        shown = glm::mix(shown, ink.colour, ink.cover);
    }
    const auto byte = [](float share) {
        return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(share, 0.0F, 1.0F)));
    };
    std::uint8_t* const rgba = made_.room.rgba.data() + 4 * pixel;
    for (int k = 0; k < 3; ++k) rgba[k] = byte(shown[k]);
    rgba[3] = byte(cover);
}

bool Painter::paint(const Work& work) {
    if (work.progress != nullptr) work.progress->enter(Stage::refining);
    const Work quiet{work.threads, work.stop, nullptr};
    if (!light_.prepare(quiet)) return false;

    const double pixels = static_cast<double>(centre_.size());
    const double first_share = 1.0 / (1.0 + expected_share * (request_.samples > 1 ? request_.samples : 0));
    std::atomic<std::size_t> done = 0;
    const auto advance = [&](std::size_t by, double whole, double from, double to) {
        const double share = static_cast<double>(done += by) / whole;
        if (work.progress != nullptr) work.progress->advance(static_cast<float>(from + (to - from) * share));
    };
    if (!for_each_tile(tiles_.count(), 1, quiet, [&](std::size_t tile, std::size_t) {
            look_at_centres(tile);
            advance(tiles_.pixels(tile).size(), pixels, 0.0, first_share);
        }))
        return false;

    std::vector<std::vector<std::size_t>> edges(tiles_.count());
    if (!for_each_tile(tiles_.count(), 1, quiet, [&](std::size_t tile, std::size_t) {
            write_tile(tile);
            if (request_.samples > 1) edges[tile] = edges_of(tile);
        }))
        return false;
    for (const auto& of_tile : edges) made_.refined += of_tile.size();

    done = 0;
    const bool finished = for_each_tile(tiles_.count(), 1, quiet, [&](std::size_t tile, std::size_t) {
        if (refine(edges[tile], work.stop) && made_.refined > 0)
            advance(edges[tile].size(), static_cast<double>(made_.refined), first_share, 1.0);
    });
    return finished && !work.stop.stop_requested();
}

}  // namespace

std::optional<ExactPicture> exact_picture(const Solution& solution, const DirectLight& direct,
                                          const ExactRequest& request, const Work& work) {
    HANEI_CHECK(solution.mesh && solution.display && has_part(solution, request.options.part));
    HANEI_CHECK(request.size.width > 0 && request.size.height > 0 && request.samples >= 1);
    Painter painter(solution, direct, request);
    if (!painter.paint(work)) return std::nullopt;
    return painter.take();
}

}  // namespace hanei
