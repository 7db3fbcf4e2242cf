/// The cells a picture draws: patches, cut finer where direct light bends, so that a desk's shadow does
/// not look like stairs.
#pragma once

#include "engine/solution/solution.h"

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace hanei {

/// Places on faces, each once, known again when they are cut anew.
class DisplayPlaces {
public:
    struct Found {
        std::uint32_t number = 0;
        bool is_new = false;
    };
    /// Needs     the same `grain`, m, in all calls since clear(): places closer than that are one.
    Found find_or_add(const SurfaceRef& face, const Receiver& place, double grain);
    std::optional<std::uint32_t> find(const SurfaceRef& face, const Receiver& place, double grain) const;
    void set(std::uint32_t number, const Receiver& place) { receivers_[number] = place; }
    void clear();
    const std::vector<Receiver>& receivers() const { return receivers_; }

private:
    struct Key {
        SurfaceRef face;
        Vec3 normal;
        std::array<long long, 3> place;
        bool operator==(const Key&) const = default;
    };
    struct Hash {
        std::size_t operator()(const Key& key) const;
    };
    static Key key_of(const SurfaceRef& face, const Receiver& place, double grain);

    std::unordered_map<Key, std::uint32_t, Hash> known_;
    std::vector<Receiver> receivers_;
};

/// A vertex of the display by the mesh vertices it lies among: bilinear in u and v.
struct DisplaySource {
    std::array<VertexId, 4> among{};
    double u = 0.0, v = 0.0;
};

/// The cell that a vertex was cut from, by its corners, and those of them that it lies in the middle of.
struct DisplayParents {
    std::array<std::uint32_t, 4> cell{}, between{};
};

struct DisplayCut {
    std::vector<DisplayCell> cells;
    std::vector<std::uint32_t> places;    ///< of the vertices, in DisplayPlaces
    std::vector<DisplaySource> sources;   ///< one a vertex
    std::vector<DisplayParents> parents;  ///< one a vertex; without meaning in the first two rounds
    std::vector<float> direct;            ///< lx, of the vertices when they were cut
    float brightest = 0.0F;               ///< of these
    std::vector<std::size_t> rounds;      ///< vertices after each round: corners of patches, first halves, ...
};

/// Whether the eye would see the difference, lx, beside the darkest place near by in a room whose brightest
/// vertex is `brightest`.
bool is_noticeable(float difference, float darkest, float brightest);

struct CutInput {
    const Mesh* mesh = nullptr;
    DisplayPlaces* places = nullptr;
    /// A place that is new, or whose receiver is another than the one kept.
    std::function<void(std::uint32_t place)> on_new;
    /// Direct light at places, lx; empty when stopped.
    std::function<std::optional<std::vector<float>>(std::span<const std::uint32_t> places)> light;
    int finest = 4;               ///< a cell is halved at most this often
    std::size_t budget = 60'000;  ///< no cell is cut once there are more vertices
};

/// Cuts a cell in four while its corners differ by more than the eye would see of it: 8 % of the
/// darkest corner and 0.5 % of the brightest vertex, and while a finer neighbour's vertex on its edge
/// differs as much from what is drawn there: a shadow found in one cell is followed into the next.
/// Every cell is cut at least once.
/// Returns   empty when stopped; the same cut whatever places were known before.
std::optional<DisplayCut> cut_display(const CutInput& input);

/// Between values at a cell's corners.
template <class T>
T bilinear(const std::array<T, 4>& corner, double u, double v) {
    return corner[0] * ((1 - u) * (1 - v)) + corner[1] * (u * (1 - v)) + corner[2] * (u * v) +
           corner[3] * ((1 - u) * v);
}

}  // namespace hanei
