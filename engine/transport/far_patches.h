/// A face's patches laid out for many quick looks from a distance: flat coordinates, single precision,
/// one number after the other.
#pragma once

#include "engine/transport/far_kernel.h"
#include "engine/transport/nodes.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hanei {

/// From a distance a patch is its four nodes; nearer by, but still small as the receiver sees it, points
/// of degree 5. Which of them will do depends on its distance alone.
///
/// Holds     the form factor to 1e-4 of it where it is nearest for its way, to 1e-5 twice as far; single
///           precision adds 1e-6.
/// Cost      0.3 us a patch to build; then see far_kernel.h.
class FarPatches {
public:
    FarPatches(const Mesh& mesh, const MeshFace& face, Elements elements, std::span<const PatchFrame> frames);

    FlatReceiver flat(const Receiver& receiver) const;

    /// The face's columns of a row as if all of it were far and above the horizon, 0 where behind it.
    void write_far(const FlatReceiver& receiver, float* columns) const;

    /// Patches, counted within the face, that are not far or that the horizon may cut.
    /// Returns   how many were written to `list`, which has room for all.
    std::size_t list_others(const FlatReceiver& receiver, bool horizon_cuts, std::uint32_t* list) const;

    /// Writes a patch's columns by its points; false where it is near or cut by the horizon.
    bool write_by_points(std::size_t patch, const FlatReceiver& receiver, bool horizon_cuts, float* columns) const;

    std::size_t patches() const { return centre_u_.size(); }

private:
    void add_patch(const Patch& patch, const PatchFrame& frame);
    void add_points(const Patch& patch, const PatchFrame& frame);
    void add_eight(const Vec3& spare);
    void add_point(std::size_t k, const Vec3& place, double area, const PatchFrame& frame);
    float flat_u(const Vec3& place) const;
    float flat_v(const Vec3& place) const;

    float square_of_distance(std::size_t patch, const FlatReceiver& receiver) const {
        const float du = centre_u_[patch] - receiver.u, dv = centre_v_[patch] - receiver.v;
        return (du * du + dv * dv) + receiver.height * receiver.height;
    }
    bool may_be_cut(std::size_t patch, const FlatReceiver& receiver) const;

    Vec3 origin_{0.0}, along_{0.0}, across_{0.0}, front_{0.0};
    double unit_ = 1.0;  ///< m; coordinates are shares of the face's size
    bool linear_ = false;
    std::array<std::vector<float>, 4> node_u_, node_v_;  ///< linear elements: all in the first, as their columns
    std::vector<float> weights_;                         ///< linear: one a node, constant: one a patch
    std::vector<float> centre_u_, centre_v_, far_square_, near_square_, extent_u_, extent_v_;
    std::vector<EightPoints> points_;
    std::vector<FourSums> node_weights_;       ///< one an eight, of linear elements
    std::vector<std::uint32_t> first_points_;  ///< one a patch and one past the end
};

/// True of a rectangle, whose nodes are the points of Gauss and whose middle has a closed form.
bool is_rectangle(const Polygon& outline);

}  // namespace hanei
