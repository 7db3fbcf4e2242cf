#include "engine/mesh/hanging.h"

#include "engine/base/tolerance.h"
#include "engine/mesh/free_sector.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hanei {

namespace {

/// Patches of one face by the squares of a grid that they reach into.
class PatchBins {
public:
    PatchBins(const Mesh& mesh, const MeshFace& face) : along_(face.face.along) {
        across_ = glm::cross(face.face.normal, along_);
        low_ = flat(mesh.patches[face.first_patch].centre);
        Vec2 high = low_;
        for (std::uint32_t k = 0; k < face.vertex_count; ++k) {
            const Vec2 place = flat(mesh.vertices[face.first_vertex + k].receiver.position);
            low_ = glm::min(low_, place);
            high = glm::max(high, place);
        }
        side_ = 1 + static_cast<int>(std::sqrt(static_cast<double>(face.patch_count)));
        scale_ = static_cast<double>(side_) / glm::max(high - low_, Vec2(1e-300));
        bins_.resize(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
        for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p) add(mesh.patches[p], p);
    }

    const std::vector<std::uint32_t>& around(const Vec3& place) const {
        const auto [column, row] = bin_of(flat(place));
        return bins_[static_cast<std::size_t>(row * side_ + column)];
    }

private:
    Vec2 flat(const Vec3& place) const { return {glm::dot(place, along_), glm::dot(place, across_)}; }

    std::pair<int, int> bin_of(const Vec2& place) const {
        const Vec2 bin = (place - low_) * scale_;
        return {std::clamp(static_cast<int>(bin.x), 0, side_ - 1), std::clamp(static_cast<int>(bin.y), 0, side_ - 1)};
    }

    /// Also to the bins beside it, lest rounding put a place of its border there.
    void add(const Patch& patch, std::uint32_t number) {
        Vec2 low = flat(patch.centre);
        Vec2 high = low;
        for (const Vec3& corner : patch.outline) {
            low = glm::min(low, flat(corner));
            high = glm::max(high, flat(corner));
        }
        const Vec2 margin = 1e-6 / scale_;
        const auto [first_column, first_row] = bin_of(low - margin);
        const auto [last_column, last_row] = bin_of(high + margin);
        for (int row = first_row; row <= last_row; ++row) {
            for (int column = first_column; column <= last_column; ++column)
                bins_[static_cast<std::size_t>(row * side_ + column)].push_back(number);
        }
    }

    Vec3 along_, across_{0.0};
    Vec2 low_{0.0}, scale_{1.0};
    int side_ = 1;
    std::vector<std::vector<std::uint32_t>> bins_;
};

/// The edge of a patch that a vertex lies in the middle of.
std::optional<HangingVertex> hung_on(const Mesh& mesh, const Patch& patch, VertexId vertex, double near) {
    const Vec3& place = mesh[vertex].receiver.position;
    const std::size_t count = patch.corners.size();
    if (std::find(patch.corners.begin(), patch.corners.end(), vertex) != patch.corners.end()) return std::nullopt;
    for (std::size_t k = 0; k < count; ++k) {
        const Vec3 edge = patch.outline[(k + 1) % count] - patch.outline[k];
        const Vec3 off = place - patch.outline[k];
        const double share = glm::dot(off, edge) / glm::dot(edge, edge);
        if (share <= 0.0 || share >= 1.0 || glm::length(off - share * edge) > near) continue;
        return HangingVertex{vertex, patch.corners[k], patch.corners[(k + 1) % count], share};
    }
    return std::nullopt;
}

/// Of two edges in one line that reach past each other's ends, each end hangs on the other edge: both
/// then take the line from one far end to the other.
void join_staggered(const Mesh& mesh, std::vector<std::optional<HangingVertex>>& hung) {
    const auto place = [&](VertexId id) -> const Vec3& { return mesh[id].receiver.position; };
    std::vector<std::optional<HangingVertex>> before;
    const auto far_end = [&](VertexId vertex,
                             VertexId end) {  // of the edge that `end` hangs on, when `vertex` is there
        const auto& next = before[static_cast<std::size_t>(end)];
        if (!next || (next->from != vertex && next->to != vertex)) return end;
        return next->from == vertex ? next->to : next->from;
    };
    bool joined = true;
    for (int round = 0; joined && round < 64; ++round) {  // each joins edges to runs twice as long
        joined = false;
        before = hung;
        for (auto& h : hung) {
            if (!h) continue;
            const VertexId from = far_end(h->vertex, h->from);
            const VertexId to = far_end(h->vertex, h->to);
            if ((from == h->from && to == h->to) || from == h->to || to == h->from) continue;
            const Vec3 line = place(to) - place(from);
            h = HangingVertex{h->vertex, from, to,
                              glm::dot(place(h->vertex) - place(from), line) / glm::dot(line, line)};
            joined = true;
        }
    }
}

/// Puts every vertex behind those that its own value is made from.
class Ordered {
public:
    explicit Ordered(const std::vector<std::optional<HangingVertex>>& hung) : hung_(hung), state_(hung.size()) {
        for (std::size_t k = 0; k < hung.size(); ++k) visit(k);
    }
    std::vector<HangingVertex> take() { return std::move(list_); }

private:
    enum class State : std::uint8_t { untouched, open, done };

    /// An explicit stack: chains are as long as rows of patches that each cut the next in two.
    void visit(std::size_t start) {
        std::vector<std::size_t> open{start};
        while (!open.empty()) {
            const std::size_t k = open.back();
            if (!hung_[k] || state_[k] == State::done) {
                open.pop_back();
                continue;
            }
            if (state_[k] == State::untouched) {
                state_[k] = State::open;
                for (const VertexId end : {hung_[k]->from, hung_[k]->to}) {
                    const auto e = static_cast<std::size_t>(end);
                    if (hung_[e] && state_[e] == State::untouched) open.push_back(e);
                }
                continue;
            }
            state_[k] = State::done;
            if (!stands_on_open(*hung_[k])) list_.push_back(*hung_[k]);
            open.pop_back();
        }
    }

    /// An end that is still being worked on depends on this vertex: a ring.
    bool stands_on_open(const HangingVertex& hanging) const {
        const auto is_open = [&](VertexId end) { return state_[static_cast<std::size_t>(end)] == State::open; };
        return is_open(hanging.from) || is_open(hanging.to);
    }

    const std::vector<std::optional<HangingVertex>>& hung_;
    std::vector<State> state_;
    std::vector<HangingVertex> list_;
};

}  // namespace

std::vector<HangingVertex> hanging_vertices(const Mesh& mesh) {
    const double near = 4.0 * tolerance::same_place * diameter_of(mesh);
    std::vector<std::optional<HangingVertex>> hung(mesh.vertices.size());
    for (const MeshFace& face : mesh.faces) {
        if (face.patch_count == 0) continue;
        const PatchBins bins(mesh, face);
        for (std::uint32_t k = face.first_vertex; k < face.first_vertex + face.vertex_count; ++k) {
            for (const std::uint32_t p : bins.around(mesh.vertices[k].receiver.position)) {
                hung[k] = hung_on(mesh, mesh.patches[p], VertexId{k}, near);
                if (hung[k]) break;
            }
        }
    }
    join_staggered(mesh, hung);
    return Ordered(hung).take();
}

}  // namespace hanei
