#include "engine/study/display_stage.h"

#include "engine/study/direct_stage.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace hanei {

namespace {

constexpr double noticeable_share = 0.08;          // of the darkest corner: a few just noticeable differences
constexpr double noticeable_of_brightest = 0.005;  // in the dark: 2 % is a plain grey on a black shadow

/// A cell in the unit square of its patch piece.
struct Cell {
    DisplayCell drawn;
    std::array<VertexId, 4> among{};
    std::array<Vec3, 4> corner{};
    double u0 = 0.0, v0 = 0.0, u1 = 1.0, v1 = 1.0;
    int halvings = 0;
};

template <class T>
T bilinear(const std::array<T, 4>& corner, double u, double v) {
    return corner[0] * ((1 - u) * (1 - v)) + corner[1] * (u * (1 - v)) + corner[2] * (u * v) +
           corner[3] * ((1 - u) * v);
}

/// Vertices of one face at equal places are one vertex: cells that share an edge share its light.
class DisplayBuilder {
public:
    explicit DisplayBuilder(const DisplayInput& input) : input_(input) {}

    bool build(const Work& work);
    DirectDisplay take() { return std::move(made_); }

private:
    struct PlaceKey {
        std::uint32_t face;
        std::array<long long, 3> place;
        bool operator==(const PlaceKey&) const = default;
    };
    struct PlaceHash {
        std::size_t operator()(const PlaceKey& key) const {
            std::uint64_t mixed = key.face;
            for (const long long part : key.place)
                mixed = (mixed ^ static_cast<std::uint64_t>(part)) * 0x9E3779B97F4A7C15U;
            return mixed ^ (mixed >> 32U);
        }
    };

    PlaceKey key_of(const Cell& cell, const Vec3& place) const;
    std::uint32_t vertex(const Cell& cell, double u, double v);
    void set_corners(Cell& cell);
    void add_pieces(std::uint32_t patch_number);
    bool light_new_vertices(const Work& work);
    bool is_cut(const Cell& cell) const;
    bool is_noticeable(float difference, float darkest) const;
    bool bends(const Cell& cell) const;
    bool misses_a_neighbour(const Cell& cell) const;
    void split(const Cell& cell, std::vector<Cell>& finer);

    const DisplayInput& input_;
    DirectDisplay made_;
    std::vector<Receiver> receivers_;
    std::unordered_map<PlaceKey, std::uint32_t, PlaceHash> known_;
    std::size_t lit_ = 0;
    std::vector<Cell> cells_;
    float brightest_ = 0.0F;
    double grain_ = 1e-6;
};

DisplayBuilder::PlaceKey DisplayBuilder::key_of(const Cell& cell, const Vec3& place) const {
    return {cell.drawn.face,
            {std::llround(place.x / grain_), std::llround(place.y / grain_), std::llround(place.z / grain_)}};
}

std::uint32_t DisplayBuilder::vertex(const Cell& cell, double u, double v) {
    const Vec3 place = bilinear(cell.corner, u, v);
    const auto [entry, is_new] = known_.try_emplace(key_of(cell, place), static_cast<std::uint32_t>(receivers_.size()));
    if (is_new) {
        made_.display.vertices.push_back({.position = place});
        made_.sources.push_back({cell.among, u, v});
        // On a border the light is that of the cell's side.
        const Vec3 inward = bilinear(cell.corner, 0.5 * (cell.u0 + cell.u1), 0.5 * (cell.v0 + cell.v1)) - place;
        const double length = glm::length(inward);
        receivers_.push_back(
            {place, input_.mesh->faces[cell.drawn.face].face.normal, length > 0.0 ? inward / length : Vec3{0.0}});
    }
    return entry->second;
}

void DisplayBuilder::set_corners(Cell& cell) {
    cell.drawn.corner[0] = vertex(cell, cell.u0, cell.v0);
    cell.drawn.corner[1] = vertex(cell, cell.u1, cell.v0);
    cell.drawn.corner[2] = vertex(cell, cell.u1, cell.v1);
    cell.drawn.corner[3] = vertex(cell, cell.u0, cell.v1);
}

void DisplayBuilder::add_pieces(std::uint32_t patch_number) {
    const Patch& patch = input_.mesh->patches[patch_number];
    const std::size_t count = patch.corners.size();
    for (std::size_t k = 1; k + 1 < count; k += 2) {
        const std::array<std::size_t, 4> corner{0, k, k + 1, std::min(k + 2, count - 1)};
        Cell cell;
        cell.drawn.face = patch.face;
        cell.drawn.patch = patch_number;
        for (std::size_t c = 0; c < 4; ++c) {
            cell.among[c] = patch.corners[corner[c]];
            cell.corner[c] = patch.outline[corner[c]];
        }
        set_corners(cell);
        cells_.push_back(cell);
    }
}

bool DisplayBuilder::light_new_vertices(const Work& work) {
    const std::span<const Receiver> fresh(receivers_.data() + lit_, receivers_.size() - lit_);
    const auto direct = direct_from_all(input_.emitters, fresh, input_.occluders, work);
    if (!direct) return false;
    for (std::size_t k = 0; k < fresh.size(); ++k) {
        const auto lux = static_cast<float>((*direct)[k]);
        made_.display.vertices[lit_ + k].direct = lux;
        brightest_ = std::max(brightest_, lux);
    }
    if (input_.open) {
        const auto open = direct_from_all(input_.emitters, fresh, nullptr, work);
        if (!open) return false;
        for (const double lux : *open) made_.open_direct.push_back(static_cast<float>(lux));
    }
    lit_ = receivers_.size();
    return true;
}

bool DisplayBuilder::is_noticeable(float difference, float darkest) const {
    return difference > std::max(noticeable_share * darkest, noticeable_of_brightest * brightest_);
}

bool DisplayBuilder::bends(const Cell& cell) const {
    std::array<float, 4> corner{};
    for (std::size_t c = 0; c < 4; ++c) corner[c] = made_.display.vertices[cell.drawn.corner[c]].direct;
    const auto [low, high] = std::minmax_element(corner.begin(), corner.end());
    return is_noticeable(*high - *low, *low);
}

/// A finer neighbour found light or shadow in the middle of an edge that the ends of the edge know nothing of.
bool DisplayBuilder::misses_a_neighbour(const Cell& cell) const {
    const double um = 0.5 * (cell.u0 + cell.u1), vm = 0.5 * (cell.v0 + cell.v1);
    const std::array<std::array<double, 2>, 4> middle{{{um, cell.v0}, {cell.u1, vm}, {um, cell.v1}, {cell.u0, vm}}};
    for (std::size_t edge = 0; edge < 4; ++edge) {
        const auto found = known_.find(key_of(cell, bilinear(cell.corner, middle[edge][0], middle[edge][1])));
        if (found == known_.end() || found->second >= lit_) continue;  // made in this round: not lit yet
        const float here = made_.display.vertices[found->second].direct;
        const float from = made_.display.vertices[cell.drawn.corner[edge]].direct;
        const float to = made_.display.vertices[cell.drawn.corner[(edge + 1) % 4]].direct;
        const float drawn = 0.5F * (from + to);
        if (is_noticeable(std::abs(here - drawn), std::min(here, drawn))) return true;
    }
    return false;
}

/// Every cell once, whatever its corners say: a shadow inside a patch may leave them all lit.
bool DisplayBuilder::is_cut(const Cell& cell) const {
    if (cell.halvings >= input_.finest || receivers_.size() >= input_.budget) return false;
    return cell.halvings == 0 || bends(cell) || misses_a_neighbour(cell);
}

void DisplayBuilder::split(const Cell& cell, std::vector<Cell>& finer) {
    const double um = 0.5 * (cell.u0 + cell.u1), vm = 0.5 * (cell.v0 + cell.v1);
    const std::array<std::array<double, 4>, 4> quarters{{{cell.u0, cell.v0, um, vm},
                                                         {um, cell.v0, cell.u1, vm},
                                                         {um, vm, cell.u1, cell.v1},
                                                         {cell.u0, vm, um, cell.v1}}};
    for (const auto& [u0, v0, u1, v1] : quarters) {
        Cell quarter = cell;
        quarter.u0 = u0, quarter.v0 = v0, quarter.u1 = u1, quarter.v1 = v1;
        ++quarter.halvings;
        set_corners(quarter);
        finer.push_back(quarter);
    }
}

bool DisplayBuilder::build(const Work& work) {
    double extent = 0.0;
    for (const Vertex& vertex : input_.mesh->vertices) {
        const Vec3 place = glm::abs(vertex.receiver.position);
        extent = std::max({extent, place.x, place.y, place.z});
    }
    grain_ = std::max(extent, 1e-12) * 1e-8;

    for (std::uint32_t patch = 0; patch < input_.mesh->patches.size(); ++patch) add_pieces(patch);
    if (!light_new_vertices(work)) return false;
    for (bool any = true; any;) {
        any = false;
        std::vector<Cell> next;
        for (const Cell& cell : cells_) {
            if (!is_cut(cell)) {
                next.push_back(cell);
                continue;
            }
            split(cell, next);
            any = true;
        }
        cells_ = std::move(next);
        if (!light_new_vertices(work)) return false;
    }
    for (const Cell& cell : cells_) made_.display.cells.push_back(cell.drawn);
    return true;
}

}  // namespace

std::vector<WeightedEmitter> emitters_of(const Scene& scene) {
    std::vector<WeightedEmitter> emitters;
    emitters.reserve(scene.luminaires.size());
    for (const Luminaire& luminaire : scene.luminaires) {
        const double share = output_share(scene, luminaire);
        if (share > 0.0) emitters.push_back({Emitter(scene, luminaire), share});
    }
    return emitters;
}

std::optional<std::vector<double>> direct_from_all(std::span<const WeightedEmitter> emitters,
                                                   std::span<const Receiver> receivers, const OccluderSet* occluders,
                                                   const Work& work) {
    std::vector<double> total(receivers.size(), 0.0);
    for (const WeightedEmitter& weighted : emitters) {
        const auto part = direct_illuminance(weighted.emitter, receivers, occluders, work);
        if (!part) return std::nullopt;
        for (std::size_t k = 0; k < total.size(); ++k) total[k] += weighted.share * (*part)[k];
    }
    return total;
}

std::optional<DirectDisplay> make_direct_display(const DisplayInput& input, const Work& work) {
    DisplayBuilder builder(input);
    if (!builder.build(work)) return std::nullopt;
    return builder.take();
}

std::shared_ptr<const DisplayMesh> dressed(const DirectDisplay& direct, std::span<const double> interreflected,
                                           std::span<const double> open_interreflected) {
    auto display = std::make_shared<DisplayMesh>(direct.display);
    display->has_unshadowed = !open_interreflected.empty();
    for (std::size_t k = 0; k < display->vertices.size(); ++k) {
        const DisplaySource& source = direct.sources[k];
        const auto among = [&](std::span<const double> values) {
            std::array<double, 4> corner{};
            for (std::size_t c = 0; c < 4; ++c) corner[c] = values[static_cast<std::size_t>(source.among[c])];
            return static_cast<float>(bilinear(corner, source.u, source.v));
        };
        display->vertices[k].interreflected = among(interreflected);
        if (display->has_unshadowed)
            display->vertices[k].unshadowed = direct.open_direct[k] + among(open_interreflected);
    }
    return display;
}

}  // namespace hanei
