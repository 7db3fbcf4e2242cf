/// Coefficients between grid points as the paper has them.
#pragma once

#include "engine/geometry/occluders.h"
#include "engine/mesh/mesh.h"

namespace hanei {

/// Factors by the paper's equation 4: cos cos / (pi r^2) times w_j A_j; they grow without bound as
/// points approach (METHOD, slips): faithful, not mended. Visibility row by row of grid points: each
/// straight row is a line source seen from P_i.
///
/// Needs     a mesh and occluders (null: none) that outlive it.
class PaperRows {
public:
    PaperRows(const Mesh& mesh, const OccluderSet* occluders) : mesh_(mesh), occluders_(occluders) {}

    /// Rows [first, last) of factors (given zeroed) and visibility (given as ones), one column a vertex.
    /// Returns   false when nothing is hidden: the visibility is left as it is.
    bool write(std::size_t first, std::size_t last, float* factors, float* shares);

private:
    void write_factors(const Vertex& at, float* row) const;

    const Mesh& mesh_;
    const OccluderSet* occluders_;
};

}  // namespace hanei
