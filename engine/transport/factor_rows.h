/// Rows of coefficients: how much the exitance at every node gives to a receiver, nothing in between.
#pragma once

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
/// Needs     a mesh and nodes that outlive it; one object a thread.
/// Holds     no coefficient is below 0, those of a patch add up to its form factor to the rounding of a
///           float: row sums of a closed room are 1. A row's bits depend on its receiver alone, not on
///           those beside it.
class FactorRows {
public:
    FactorRows(const Mesh& mesh, const Nodes& nodes);

    std::size_t columns() const { return nodes_.size(); }

    /// Row k for receiver k, written to `rows` + k x columns().
    /// Needs     rows of zeros: columns of faces turned away stay as they are.
    void write(std::span<const Receiver> side_by_side, float* rows);

private:
    void write_face(const FaceLayout& layout, const Receiver& receiver, FaceSeen seen, float* row) const;

    const Mesh& mesh_;
    const Nodes& nodes_;
    std::vector<FaceLayout> layouts_;
};

}  // namespace hanei
