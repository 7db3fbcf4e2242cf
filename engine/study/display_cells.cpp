#include "engine/study/display_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hanei {

namespace {

constexpr double noticeable_share = 0.08;          // of the darkest corner: a few just noticeable differences
constexpr double noticeable_of_brightest = 0.005;  // in the dark: 2 % is a plain grey on a black shadow
constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

/// A cell in the unit square of its patch piece.
struct Cell {
    DisplayCell drawn;
    std::array<VertexId, 4> among{};
    std::array<Vec3, 4> corner{};
    double u0 = 0.0, v0 = 0.0, u1 = 1.0, v1 = 1.0;
    int halvings = 0;
};

/// 1e-8 of the extent, a power of two: it stays the same while a room grows a little.
double grain_of(double extent) { return std::exp2(std::ceil(std::log2(std::max(extent, 1e-12) * 1e-8))); }

/// Vertices of one face at equal places are one vertex: cells that share an edge share its light.
class Cutter {
public:
    explicit Cutter(const CutInput& input) : input_(input), mesh_(*input.mesh) {
        double extent = 0.0;
        for (const Vertex& vertex : mesh_.vertices) {
            const Vec3 place = glm::abs(vertex.receiver.position);
            extent = std::max({extent, place.x, place.y, place.z});
        }
        grain_ = grain_of(extent);
    }

    bool build();
    DisplayCut take() { return std::move(made_); }

private:
    std::uint32_t vertex(const Cell& cell, double u, double v);
    void set_corners(Cell& cell);
    void add_pieces(std::uint32_t patch_number);
    bool light_new_vertices();
    bool is_cut(const Cell& cell) const;
    bool bends(const Cell& cell) const;
    bool misses_a_neighbour(const Cell& cell) const;
    void make_middles(const Cell& cell, double um, double vm);
    void split(const Cell& cell, std::vector<Cell>& finer);

    const CutInput& input_;
    const Mesh& mesh_;
    DisplayCut made_;
    std::vector<std::uint32_t> vertex_at_;  ///< a place's vertex in this cut
    std::vector<Cell> cells_;
    DisplayParents parents_;  ///< of vertices that are being made
    double grain_ = 1e-6;
};

std::uint32_t Cutter::vertex(const Cell& cell, double u, double v) {
    const Face& face = mesh_.faces[cell.drawn.face].face;
    Receiver place{bilinear(cell.corner, u, v), face.normal, {}};
    const auto [number, is_new] = input_.places->find_or_add(face.ref, place, grain_);
    if (number >= vertex_at_.size())
        vertex_at_.resize(std::max<std::size_t>(number + 1, 2 * vertex_at_.size()), nowhere);
    if (vertex_at_[number] != nowhere) return vertex_at_[number];
    // On a border the light is that of the cell's side.
    const Vec3 inward = bilinear(cell.corner, 0.5 * (cell.u0 + cell.u1), 0.5 * (cell.v0 + cell.v1)) - place.position;
    const double length = glm::length(inward);
    if (length > 0.0) place.inward = inward / length;
    if (is_new || input_.places->receivers()[number] != place) {
        input_.places->set(number, place);
        input_.on_new(number);
    }
    vertex_at_[number] = static_cast<std::uint32_t>(made_.places.size());
    made_.places.push_back(number);
    made_.sources.push_back({cell.among, u, v});
    made_.parents.push_back(parents_);
    return vertex_at_[number];
}

void Cutter::set_corners(Cell& cell) {
    cell.drawn.corner[0] = vertex(cell, cell.u0, cell.v0);
    cell.drawn.corner[1] = vertex(cell, cell.u1, cell.v0);
    cell.drawn.corner[2] = vertex(cell, cell.u1, cell.v1);
    cell.drawn.corner[3] = vertex(cell, cell.u0, cell.v1);
}

void Cutter::add_pieces(std::uint32_t patch_number) {
    const Patch& patch = mesh_.patches[patch_number];
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

bool Cutter::light_new_vertices() {
    const auto lit = input_.light(std::span(made_.places).subspan(made_.direct.size()));
    if (!lit) return false;
    for (const float lux : *lit) made_.brightest = std::max(made_.brightest, lux);
    made_.direct.insert(made_.direct.end(), lit->begin(), lit->end());
    made_.rounds.push_back(made_.places.size());
    return true;
}

bool Cutter::bends(const Cell& cell) const {
    std::array<float, 4> corner{};
    for (std::size_t c = 0; c < 4; ++c) corner[c] = made_.direct[cell.drawn.corner[c]];
    const auto [low, high] = std::minmax_element(corner.begin(), corner.end());
    return is_noticeable(*high - *low, *low, made_.brightest);
}

/// A finer neighbour found light or shadow in the middle of an edge that the ends of the edge know nothing of.
bool Cutter::misses_a_neighbour(const Cell& cell) const {
    const double um = 0.5 * (cell.u0 + cell.u1), vm = 0.5 * (cell.v0 + cell.v1);
    const std::array<std::array<double, 2>, 4> middle{{{um, cell.v0}, {cell.u1, vm}, {um, cell.v1}, {cell.u0, vm}}};
    const Face& face = mesh_.faces[cell.drawn.face].face;
    for (std::size_t edge = 0; edge < 4; ++edge) {
        const Vec3 place = bilinear(cell.corner, middle[edge][0], middle[edge][1]);
        const auto known = input_.places->find(face.ref, {place, face.normal, {}}, grain_);
        if (!known || *known >= vertex_at_.size()) continue;
        const std::uint32_t found = vertex_at_[*known];
        if (found >= made_.direct.size()) continue;  // not of this cut, or made in this round: not lit yet
        const float here = made_.direct[found];
        const float from = made_.direct[cell.drawn.corner[edge]];
        const float to = made_.direct[cell.drawn.corner[(edge + 1) % 4]];
        const float drawn = 0.5F * (from + to);
        if (is_noticeable(std::abs(here - drawn), std::min(here, drawn), made_.brightest)) return true;
    }
    return false;
}

/// Every cell once, whatever its corners say: a shadow inside a patch may leave them all lit.
bool Cutter::is_cut(const Cell& cell) const {
    if (cell.halvings >= input_.finest || made_.places.size() >= input_.budget) return false;
    return cell.halvings == 0 || bends(cell) || misses_a_neighbour(cell);
}

/// The middles of the cell's edges and its own.
void Cutter::make_middles(const Cell& cell, double um, double vm) {
    const auto corner = [&](std::size_t k) { return cell.drawn.corner[k % 4]; };
    const std::array<std::array<double, 2>, 4> middle{{{um, cell.v0}, {cell.u1, vm}, {um, cell.v1}, {cell.u0, vm}}};
    parents_.cell = {corner(0), corner(1), corner(2), corner(3)};
    for (std::size_t edge = 0; edge < 4; ++edge) {
        parents_.between = {corner(edge), corner(edge + 1), corner(edge), corner(edge + 1)};
        vertex(cell, middle[edge][0], middle[edge][1]);
    }
    parents_.between = parents_.cell;
    vertex(cell, um, vm);
}

void Cutter::split(const Cell& cell, std::vector<Cell>& finer) {
    const double um = 0.5 * (cell.u0 + cell.u1), vm = 0.5 * (cell.v0 + cell.v1);
    const std::array<std::array<double, 4>, 4> quarters{{{cell.u0, cell.v0, um, vm},
                                                         {um, cell.v0, cell.u1, vm},
                                                         {um, vm, cell.u1, cell.v1},
                                                         {cell.u0, vm, um, cell.v1}}};
    make_middles(cell, um, vm);
    for (const auto& [u0, v0, u1, v1] : quarters) {
        Cell quarter = cell;
        quarter.u0 = u0, quarter.v0 = v0, quarter.u1 = u1, quarter.v1 = v1;
        ++quarter.halvings;
        set_corners(quarter);
        finer.push_back(quarter);
    }
}

bool Cutter::build() {
    for (std::uint32_t patch = 0; patch < mesh_.patches.size(); ++patch) add_pieces(patch);
    if (!light_new_vertices()) return false;
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
        if (!light_new_vertices()) return false;
    }
    for (const Cell& cell : cells_) made_.cells.push_back(cell.drawn);
    return true;
}

}  // namespace

DisplayPlaces::Key DisplayPlaces::key_of(const SurfaceRef& face, const Receiver& place, double grain) {
    return {face,
            place.normal,
            {std::llround(place.position.x / grain), std::llround(place.position.y / grain),
             std::llround(place.position.z / grain)}};
}

std::size_t DisplayPlaces::Hash::operator()(const Key& key) const {
    std::uint64_t mixed = (static_cast<std::uint64_t>(key.face.object.value) << 32U) ^
                          static_cast<std::uint64_t>(static_cast<std::uint32_t>(key.face.face));
    for (const long long part : key.place) mixed = (mixed ^ static_cast<std::uint64_t>(part)) * 0x9E3779B97F4A7C15U;
    return mixed ^ (mixed >> 32U);
}

DisplayPlaces::Found DisplayPlaces::find_or_add(const SurfaceRef& face, const Receiver& place, double grain) {
    const auto [entry, is_new] =
        known_.try_emplace(key_of(face, place, grain), static_cast<std::uint32_t>(receivers_.size()));
    if (is_new) receivers_.push_back(place);
    return {entry->second, is_new};
}

std::optional<std::uint32_t> DisplayPlaces::find(const SurfaceRef& face, const Receiver& place, double grain) const {
    const auto found = known_.find(key_of(face, place, grain));
    return found == known_.end() ? std::nullopt : std::optional(found->second);
}

void DisplayPlaces::clear() {
    known_.clear();
    receivers_.clear();
}

bool is_noticeable(float difference, float darkest, float brightest) {
    return difference > std::max(noticeable_share * static_cast<double>(darkest),
                                 noticeable_of_brightest * static_cast<double>(brightest));
}

std::optional<DisplayCut> cut_display(const CutInput& input) {
    Cutter cutter(input);
    if (!cutter.build()) return std::nullopt;
    return cutter.take();
}

}  // namespace hanei
