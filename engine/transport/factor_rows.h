/// Rows of coefficients: how much the exitance at every node gives to a receiver, nothing in between.
#pragma once

#include "engine/transport/far_patches.h"
#include "engine/transport/kernel_middle.h"
#include "engine/transport/nodes.h"
#include "engine/transport/seen_face.h"

#include <span>
#include <vector>

namespace hanei {

/// For constant elements the form factor of the patch. For linear ones the product of kernel and basis
/// integrated over the patch, but for what would be below 0 where nearly all light comes from one edge
/// (node_shares).
///
/// Per face and receiver: patches small as they are seen by a few points in single precision, those
/// nearby in closed form, those cut by the horizon by their contour.
///
/// Needs     a mesh and nodes that outlive it.
/// Holds     no coefficient is below 0; those of a patch add up to its form factor to 1e-4 of it (2e-4
///           where the horizon nearly cuts it), rows of a closed room to 1 within 3e-6. A row's bits depend on its
///           receiver alone, not on those beside it. Any number of threads may write at once.
/// Cost      a receiver and a patch of an empty room 7, 4, 2.5 ns among 500, 1000, 2000 patches, twice that
///           for linear elements; in a furnished room twice that again, most of it for patches that the
///           horizon cuts. 1 us a patch to make it.
class FactorRows {
public:
    FactorRows(const Mesh& mesh, const Nodes& nodes);

    std::size_t columns() const { return nodes_.size(); }

    /// Row k for receiver k, written to `rows` + k x columns().
    /// Needs     rows of zeros: columns of faces turned away stay as they are.
    void write(std::span<const Receiver> side_by_side, float* rows) const;

private:
    void write_face(std::size_t face, const Receiver& receiver, std::span<std::uint32_t> others, float* row) const;
    void write_touching(const FaceLayout& layout, const Receiver& receiver, float* row) const;
    void write_nearby(std::size_t patch, const Receiver& receiver, bool horizon_cuts, float* row) const;

    const Mesh& mesh_;
    const Nodes& nodes_;
    std::vector<FaceLayout> layouts_;
    std::vector<FarPatches> flat_;    // one a layout
    std::vector<PatchFrame> frames_;  // one a patch
    std::vector<bool> rectangles_;
    std::size_t most_patches_ = 0;
};

}  // namespace hanei
