/// The patches of a face in its own plane, laid out so that four are held against a line at once.
#pragma once

#include "engine/geometry/four.h"
#include "engine/transport/flat_loop.h"
#include "engine/transport/seen_face.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <span>
#include <vector>

namespace hanei {

/// Every place that floats tell; empty bounds, which begin beyond it, do not meet it.
inline constexpr double farthest = std::numeric_limits<float>::max();
inline constexpr FlatBox everywhere{-farthest, -farthest, farthest, farthest};

inline FlatBox around(const FlatBox& a, const FlatBox& b) {
    return {std::min(a.low_u, b.low_u), std::min(a.low_v, b.low_v), std::max(a.high_u, b.high_u),
            std::max(a.high_v, b.high_v)};
}

inline FlatBox common(const FlatBox& a, const FlatBox& b) {
    return {std::max(a.low_u, b.low_u), std::max(a.low_v, b.low_v), std::min(a.high_u, b.high_u),
            std::min(a.high_v, b.high_v)};
}

/// A line in single precision, as it is held against four places or bounds.
struct FourLine {
    Four a, b, c, size_a, size_b;

    explicit FourLine(const FlatLine& line);
};

/// Holds     places relative to `origin`, the middle of the face, so that floats tell lines that cross it
///           to 4e-7 of its radius.
struct ShadedFace {
    static constexpr std::size_t lanes = 4;
    static constexpr std::size_t most_corners = 12;

    /// Bounds of four patches. Lanes past the last patch repeat it.
    struct Group {
        Four u, v, half_u, half_v;
        Four slack;  ///< a patch this near to a line does not cross it
    };
    /// Bounds of four groups, outward by the rounding of floats; lanes past the last are empty.
    struct Block {
        Four low_u, low_v, high_u, high_v;
    };

    const FaceLayout* layout = nullptr;
    Vec3 origin{0.0};
    Vec3 along{0.0}, across{0.0}, normal{0.0};
    double radius = 0.0;               ///< of a circle around `origin` that holds the face
    FlatLoop corners;                  ///< of a convex polygon that all patches lie in
    std::vector<Group> groups;         ///< patches 4 k to 4 k + 3
    std::vector<Block> blocks;         ///< groups 4 k to 4 k + 3
    std::vector<std::uint32_t> first;  ///< into u and v, one a patch and one past the end
    std::vector<double> u, v;          ///< corners of patches
    std::vector<float> patch_radius;   ///< around the middle of a patch's bounds

    explicit ShadedFace(const Mesh& mesh, const FaceLayout& of);

    std::size_t size() const { return patch_radius.size(); }
    std::size_t corner_count(std::size_t patch) const { return first[patch + 1] - first[patch]; }
    double middle_u(std::size_t patch) const { return groups[patch / lanes].u[patch % lanes]; }
    double middle_v(std::size_t patch) const { return groups[patch / lanes].v[patch % lanes]; }
    FlatLoop loop(std::size_t patch) const;

    /// Groups of a block that may meet the part of the face inside all lines, a bit each.
    unsigned reached(const Block& block, const FlatBox& shade) const;

    /// Bounds of that part: of all patches where it is not worth while; empty where there is none.
    FlatBox shade_of(std::span<const FlatLine> lines) const;

private:
    void add_to_block(std::size_t group, const FlatBox& box);
};

/// Calls `found(patch, crossed)` for every patch that is not beyond one of the lines: `crossed` where it
/// may not lie inside all of them. Only groups that meet `within` are looked at.
template <class Found>
void for_each_shaded(const ShadedFace& face, std::span<const FourLine> lines, const FlatBox& within, Found&& found) {
    for (std::size_t block = 0; block < face.blocks.size(); ++block) {
        for (unsigned groups = face.reached(face.blocks[block], within); groups != 0; groups &= groups - 1) {
            const std::size_t group = ShadedFace::lanes * block + static_cast<std::size_t>(std::countr_zero(groups));
            if (group >= face.groups.size()) break;  // empty lanes lie at infinity, which an unbounded shade meets
            const ShadedFace::Group patches = face.groups[group];
            FourFlags beyond{}, crossed{};
            for (const FourLine& line : lines) {
                const Four height = patches.u * line.a + patches.v * line.b + line.c;
                const Four reach = patches.half_u * line.size_a + patches.half_v * line.size_b;
                beyond |= height - reach >= -patches.slack;
                crossed |= height + reach > patches.slack;
            }
            const int is_crossed = bits_of(crossed);
            for (auto bits = static_cast<unsigned>(bits_of(beyond)) ^ 15U; bits != 0; bits &= bits - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
                const std::size_t patch = ShadedFace::lanes * group + lane;
                if (patch < face.size()) found(patch, (is_crossed >> lane & 1) != 0);
            }
        }
    }
}

}  // namespace hanei
