#include "ui/view/isolux_labels.h"

#include "ui/view/value_buffer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <iterator>

namespace hanei {
namespace {

constexpr int buffer_height = 300;       // rows: a line of text is 4 to 5 of them in a picture of 800
constexpr int coarse_height = 90;        // rows: where a line runs, not where its figure fits
constexpr double text_height = 13.0;     // pixels at scale 1
constexpr double digit_width = 7.0;      // pixels at scale 1, figures of 12 pixels
constexpr double text_margin = 5.0;      // pixels kept free around
constexpr int labels_a_line = 3;         // in pictures that have the room; small ones name a line once
constexpr int small_picture = 500;       // rows at scale 1
constexpr double least_distance = 0.35;  // picture heights between two labels of one figure
constexpr double worst_clutter = 0.15;   // of the label's area: more and it reads as belonging elsewhere
constexpr double steepest = 1.12;        // ratio of neighbouring pixels: beyond, a line has no place of its own

/// One visible piece of one line: the buffer's pixels it runs through.
struct LinePiece {
    int level = 0;
    std::vector<int> pixels;
};

class Crossings {
public:
    Crossings(const ValueBuffer& buffer, const std::vector<double>& steps) : buffer_(buffer) {
        level_.assign(buffer.lux.size(), none);
        edge_.assign(buffer.lux.size(), 0);
        for (int y = 0; y + 1 < buffer.size.height; ++y) {
            for (int x = 0; x + 1 < buffer.size.width; ++x) {
                mark(buffer.at(x, y), buffer.at(x + 1, y), steps);
                mark(buffer.at(x, y), buffer.at(x, y + 1), steps);
            }
        }
    }

    /// Pieces in the order of their first pixel.
    std::vector<LinePiece> pieces() {
        std::vector<LinePiece> found;
        std::vector<char> seen(level_.size(), 0);
        for (int start = 0; start < static_cast<int>(level_.size()); ++start) {
            if (level_[index(start)] < 0 || seen[index(start)] != 0) continue;
            LinePiece piece{level_[index(start)], {start}};
            seen[index(start)] = 1;
            for (std::size_t k = 0; k < piece.pixels.size(); ++k) grow(piece, piece.pixels[k], seen);
            found.push_back(std::move(piece));
        }
        return found;
    }

    /// Share of a box that other lines, edges and other surfaces take up; 1 when it leaves the picture.
    double clutter(int x, int y, int half_width, int half_height, int own) const {
        const PixelSize& size = buffer_.size;
        const bool leaves = x - half_width < 1 || y - half_height < 1 || x + half_width >= size.width - 1 ||
                            y + half_height >= size.height - 1;
        if (leaves) return 1.0;
        const int face = buffer_.face[buffer_.at(x, y)];
        double disturbing = 0.0;
        for (int v = y - half_height; v <= y + half_height; ++v) {
            for (int u = x - half_width; u <= x + half_width; ++u) {
                const std::size_t pixel = buffer_.at(u, v);
                const bool other_line = level_[pixel] != none && level_[pixel] != own;
                if (other_line || edge_[pixel] != 0 || buffer_.face[pixel] != face) disturbing += 1.0;
            }
        }
        return disturbing / ((2.0 * half_width + 1.0) * (2.0 * half_height + 1.0));
    }

private:
    static constexpr int none = -1;
    static constexpr int several = -2;  // too steep to tell the lines apart

    static std::size_t index(int pixel) { return static_cast<std::size_t>(pixel); }

    static int steps_under(double lux, const std::vector<double>& steps) {
        return static_cast<int>(std::upper_bound(steps.begin(), steps.end(), lux) - steps.begin());
    }

    static double ratio(float a, float b) {
        return static_cast<double>(std::max(a, b)) / std::max(1e-9, static_cast<double>(std::min(a, b)));
    }

    void mark(std::size_t a, std::size_t b, const std::vector<double>& steps) {
        if (buffer_.face[a] != buffer_.face[b]) {
            edge_[a] = 1;
            return;
        }
        if (buffer_.face[a] < 0) return;
        const int low = steps_under(static_cast<double>(buffer_.lux[a]), steps);
        const int high = steps_under(static_cast<double>(buffer_.lux[b]), steps);
        if (low == high) return;
        const bool readable = std::abs(high - low) == 1 && ratio(buffer_.lux[a], buffer_.lux[b]) < steepest;
        level_[a] = readable && level_[a] != several ? std::min(low, high) : several;
    }

    void grow(LinePiece& piece, int from, std::vector<char>& seen) const {
        const int x = from % buffer_.size.width, y = from / buffer_.size.width;
        for (int v = std::max(0, y - 1); v <= std::min(buffer_.size.height - 1, y + 1); ++v) {
            for (int u = std::max(0, x - 1); u <= std::min(buffer_.size.width - 1, x + 1); ++u) {
                const std::size_t pixel = buffer_.at(u, v);
                if (seen[pixel] != 0 || level_[pixel] != piece.level) continue;
                seen[pixel] = 1;
                piece.pixels.push_back(static_cast<int>(pixel));
            }
        }
    }

    const ValueBuffer& buffer_;
    std::vector<int> level_;
    std::vector<char> edge_;
};

struct Placed {
    int x = 0, y = 0, half_width = 0, half_height = 0, level = 0;
};

bool in_the_way(const Placed& label, const Placed& other, double distance) {
    const int dx = std::abs(label.x - other.x), dy = std::abs(label.y - other.y);
    if (dx <= label.half_width + other.half_width && dy <= label.half_height + other.half_height) return true;
    return label.level == other.level && std::hypot(dx, dy) < distance;
}

/// The least cluttered free place along a piece; half_width 0 when there is none.
Placed best_place(const LinePiece& piece, const Crossings& crossings, const std::vector<Placed>& placed, Placed label,
                  int width) {
    Placed best;
    double least = worst_clutter;
    for (const int pixel : piece.pixels) {
        label.x = pixel % width;
        label.y = pixel / width;
        const bool taken = std::any_of(placed.begin(), placed.end(), [&](const Placed& other) {
            return in_the_way(label, other, least_distance * buffer_height);
        });
        if (taken) continue;
        const double clutter = crossings.clutter(label.x, label.y, label.half_width, label.half_height, piece.level);
        if (clutter >= least) continue;
        least = clutter;
        best = label;
        if (clutter == 0.0) break;
    }
    return best;
}

}  // namespace

std::string lux_text(double lux) {
    if (lux >= 1000.0) return fmt::format("{:.0f}", lux);
    if (lux >= 0.995) return fmt::format("{:.4g}", lux);
    return fmt::format("{:.2g}", lux);
}

std::string lux_text(double lux, IlluminanceUnit unit) { return lux_text(lux / lux_in(unit)); }

std::vector<IsoluxLabel> labels_that_hold(const std::vector<IsoluxLabel>& labels, const Solution& solution,
                                          const Camera& camera, const ViewOptions& look, PixelSize size) {
    std::vector<IsoluxLabel> holding;
    if (labels.empty() || solution.display == nullptr || size.width < 2 || size.height < 2) return holding;
    const PixelSize small{std::max(3, size.width * coarse_height / size.height), coarse_height};
    const ValueBuffer buffer = value_buffer(solution, camera, look, small);
    const auto runs_by = [&](const IsoluxLabel& label) {
        const int x = std::clamp(static_cast<int>(label.at.x * small.width), 1, small.width - 2);
        const int y = std::clamp(static_cast<int>(label.at.y * small.height), 1, small.height - 2);
        const int face = buffer.face[buffer.at(x, y)];
        bool above = false, below = false;
        for (int v = y - 1; v <= y + 1; ++v) {
            for (int u = x - 1; u <= x + 1; ++u) {
                const std::size_t pixel = buffer.at(u, v);
                if (buffer.face[pixel] != face || face < 0) continue;
                const bool more = static_cast<double>(buffer.lux[pixel]) >= label.lux;
                above |= more;
                below |= !more;
            }
        }
        return above && below;
    };
    std::copy_if(labels.begin(), labels.end(), std::back_inserter(holding), runs_by);
    return holding;
}

std::vector<IsoluxLabel> isolux_labels(const Solution& solution, const Camera& camera, const ViewOptions& look,
                                       PixelSize size, double scale) {
    std::vector<IsoluxLabel> labels;
    const bool shown =
        look.isolux && look.scale == Scale::false_colour && !look.shadow_classes && has_part(solution, look.part);
    if (!shown || solution.mesh == nullptr || size.width < 2 || size.height < 2) return labels;
    const std::vector<double> steps = isolux_levels(look);
    const double shrink = static_cast<double>(buffer_height) / size.height;
    const PixelSize small{std::max(2, static_cast<int>(std::lround(size.width * shrink))), buffer_height};
    const ValueBuffer buffer = value_buffer(solution, camera, look, small);
    Crossings crossings(buffer, steps);
    std::vector<LinePiece> pieces = crossings.pieces();
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const LinePiece& a, const LinePiece& b) { return a.pixels.size() > b.pixels.size(); });
    const int most = size.height < small_picture * scale ? 1 : labels_a_line;
    std::vector<Placed> placed;
    for (const LinePiece& piece : pieces) {
        const double lux = steps[static_cast<std::size_t>(piece.level)];
        Placed label;
        label.level = piece.level;
        const double digits = static_cast<double>(lux_text(lux, look.unit).size());
        label.half_width =
            static_cast<int>(std::ceil(0.5 * scale * shrink * (digits * digit_width + 2.0 * text_margin)));
        label.half_height = static_cast<int>(std::ceil(0.5 * scale * shrink * (text_height + text_margin)));
        for (int k = 0; k < most; ++k) {
            if (static_cast<int>(piece.pixels.size()) < 4 * label.half_width * (k + 1)) break;
            const Placed place = best_place(piece, crossings, placed, label, small.width);
            if (place.half_width == 0) break;
            placed.push_back(place);
            labels.push_back(
                {Vec2((place.x + 1.0) / small.width, (place.y + 1.0) / small.height), lux, lux_text(lux, look.unit)});
        }
    }
    return labels;
}

}  // namespace hanei
