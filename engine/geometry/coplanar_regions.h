/// Neighbouring triangles of a shell in one plane, and the outlines they have together.
#pragma once

#include "engine/geometry/flat_faces.h"

#include <cstdint>
#include <optional>
#include <unordered_map>

namespace hanei {

/// Simple outlines, flat enough, holes within the plane: what check_region and check_solid ask for.
bool is_sound_face(const std::vector<Vec3>& vertices, const FlatFace& face);

/// Takes a shell apart, region by region, the one with the largest triangle first.
///
/// Holds     a reference to the shell.
class CoplanarRegions {
public:
    CoplanarRegions(const TriangleShell& shell, bool keep_labels);

    using Region = std::vector<std::size_t>;  ///< triangles, neighbours one after another
    std::optional<Region> next();

    /// One face with its holes; none when the outline touches itself, or there is more than one.
    std::vector<FlatFace> with_holes(const Region& region) const;
    /// Simple faces that together cover it.
    std::vector<FlatFace> without_holes(const Region& region) const;

private:
    int neighbour(std::size_t triangle, std::size_t side) const;  ///< -1: none
    FlatFace described(const std::vector<std::size_t>& triangles, std::vector<int> loop) const;
    std::vector<FlatFace> one_by_one(const std::vector<std::size_t>& triangles) const;

    const TriangleShell& shell_;
    bool keep_labels_;
    std::vector<Vec3> areas_;
    std::vector<std::size_t> by_area_;
    std::size_t first_ = 0;
    std::vector<bool> taken_;
    std::unordered_map<std::uint64_t, int> across_;  ///< by the edge as the triangle beyond runs it
};

}  // namespace hanei
