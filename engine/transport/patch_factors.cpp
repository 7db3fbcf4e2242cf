#include "engine/base/tiles.h"
#include "engine/geometry/arc_tangent.h"
#include "engine/transport/factors.h"
#include "engine/transport/seen_face.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei {

namespace {

constexpr std::size_t rows_a_tile = 16;

/// Lambert's contour integral for all patches of a face at once.
class FaceKernel {
public:
    /// Form factors of the face's patches, written to their columns of a row.
    void write(const FaceLayout& layout, const Mesh& mesh, const Receiver& receiver, FaceSeen seen, float* row) {
        see_vertices(layout, receiver);
        weigh_edges(layout, receiver.normal, seen == FaceSeen::wholly);
        const MeshFace& face = *layout.face;
        for (std::uint32_t p = 0; p < face.patch_count; ++p) {
            const Patch& patch = mesh.patches[face.first_patch + p];
            double factor = 0.0;
            if (seen == FaceSeen::wholly || is_above_horizon(layout, p)) {
                factor = sum_of_edges(layout, p);
            } else if (is_partly_above_horizon(layout, p)) {
                factor = configuration_factor(patch.outline, receiver);
            }
            row[face.first_patch + p] = static_cast<float>(std::clamp(factor, 0.0, 1.0));
        }
    }

private:
    void see_vertices(const FaceLayout& layout, const Receiver& receiver) {
        seen_.resize(layout.vertices.size());
        heights_.resize(layout.vertices.size());
        for (std::size_t k = 0; k < seen_.size(); ++k) {
            seen_[k] = layout.vertices[k] - receiver.position;
            heights_[k] = glm::dot(seen_[k], receiver.normal);
        }
    }

    /// Angle of every edge times the cosine between its plane and the receiver's normal.
    void weigh_edges(const FaceLayout& layout, const Vec3& normal, bool all) {
        shares_.resize(layout.edges.size());
        for (std::size_t k = 0; k < shares_.size(); ++k) {
            const auto [from, to] = layout.edges[k];
            if (!all && (heights_[from] < 0.0 || heights_[to] < 0.0)) continue;
            const Vec3& a = seen_[from];
            const Vec3& b = seen_[to];
            const Vec3 across = glm::cross(b - a, a);
            const double square = glm::dot(across, across);
            shares_[k] = square > 0.0 ? angle_over_cross(square, glm::dot(a, b)) * glm::dot(across, normal) : 0.0;
        }
    }

    double sum_of_edges(const FaceLayout& layout, std::uint32_t patch) const {
        double sum = 0.0;
        for (std::uint32_t k = layout.first_edge[patch]; k < layout.first_edge[patch + 1]; ++k) {
            const std::int32_t edge = layout.edges_of[k];
            sum +=
                edge > 0 ? shares_[static_cast<std::size_t>(edge - 1)] : -shares_[static_cast<std::size_t>(-edge - 1)];
        }
        return sum / (2.0 * std::numbers::pi);
    }

    template <class Test>
    bool any_corner(const FaceLayout& layout, std::uint32_t patch, Test&& test) const {
        for (std::uint32_t k = layout.first_edge[patch]; k < layout.first_edge[patch + 1]; ++k) {
            const auto [from, to] = layout.edges[static_cast<std::size_t>(std::abs(layout.edges_of[k]) - 1)];
            if (test(heights_[from]) || test(heights_[to])) return true;
        }
        return false;
    }
    bool is_above_horizon(const FaceLayout& layout, std::uint32_t patch) const {
        return !any_corner(layout, patch, [](double height) { return height < 0.0; });
    }
    bool is_partly_above_horizon(const FaceLayout& layout, std::uint32_t patch) const {
        return any_corner(layout, patch, [](double height) { return height > 0.0; });
    }

    std::vector<Vec3> seen_;
    std::vector<double> heights_;
    std::vector<double> shares_;
};

/// A receiver in the plane of a face sees only patches that reach it.
void write_touching(const FaceLayout& layout, const Mesh& mesh, const Receiver& receiver, float* row) {
    const MeshFace& face = *layout.face;
    const double height = glm::dot(receiver.position - layout.corners.front(), face.face.normal);
    for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p) {
        if (height <= layout.same_place && !reaches(mesh.patches[p], receiver.position, layout.same_place)) continue;
        row[p] = static_cast<float>(configuration_factor(mesh.patches[p].outline, receiver));
    }
}

}  // namespace

std::optional<DenseRows> patch_factors(const Mesh& mesh, std::span<const Receiver> receivers, const Work& work) {
    DenseRows factors{receivers.size(), mesh.patches.size(), {}};
    factors.values.resize(factors.rows * factors.columns);
    const std::vector<FaceLayout> layouts = layouts_of(mesh);
    const bool finished = for_each_tile(receivers.size(), rows_a_tile, work, [&](std::size_t begin, std::size_t end) {
        FaceKernel kernel;
        for (const FaceLayout& layout : layouts) {
            for (std::size_t k = begin; k < end; ++k) {
                float* row = factors.values.data() + k * factors.columns;
                const FaceSeen seen = seen_from(layout, receivers[k]);
                if (seen == FaceSeen::touching) write_touching(layout, mesh, receivers[k], row);
                if (seen == FaceSeen::wholly || seen == FaceSeen::partly) {
                    kernel.write(layout, mesh, receivers[k], seen, row);
                }
            }
        }
    });
    if (!finished) return std::nullopt;
    return factors;
}

}  // namespace hanei
