/// The patches of a face in its own plane, laid out so that four are held against a line at once.
#pragma once

#include "engine/geometry/four.h"
#include "engine/transport/flat_loop.h"
#include "engine/transport/seen_face.h"

#include <vector>

namespace hanei {

/// Holds     places relative to `origin`, the middle of the face, so that floats tell lines that cross it
///           to 4e-7 of its radius.
struct ShadedFace {
    static constexpr std::size_t lanes = 4;
    static constexpr std::size_t most_corners = 12;

    /// Bounds of four patches, and of all of them together. Lanes past the last patch repeat it.
    struct Group {
        Four u, v, half_u, half_v;
        Four slack;  ///< a patch this near to a line does not cross it
        FlatBox box;
    };

    const FaceLayout* layout = nullptr;
    Vec3 origin{0.0};
    Vec3 along{0.0}, across{0.0}, normal{0.0};
    double radius = 0.0;               ///< of a circle around `origin` that holds the face
    FlatLoop corners;                  ///< of a convex polygon that all patches lie in
    std::vector<Group> groups;         ///< patches 4 k to 4 k + 3
    std::vector<std::uint32_t> first;  ///< into u and v, one a patch and one past the end
    std::vector<double> u, v;          ///< corners of patches
    std::vector<float> patch_radius;   ///< around the middle of a patch's bounds

    explicit ShadedFace(const Mesh& mesh, const FaceLayout& of);

    std::size_t size() const { return patch_radius.size(); }
    std::size_t corner_count(std::size_t patch) const { return first[patch + 1] - first[patch]; }
    double middle_u(std::size_t patch) const { return groups[patch / lanes].u[patch % lanes]; }
    double middle_v(std::size_t patch) const { return groups[patch / lanes].v[patch % lanes]; }
    FlatLoop loop(std::size_t patch) const;
};

}  // namespace hanei
