/// Values with their error bars at calculation points, and means of faces.
#pragma once

#include "engine/solution/solution.h"
#include "engine/study/display_stage.h"
#include "engine/transport/energy.h"

namespace hanei {

/// All authored points and grid points, in the order points, then grids; locations filled, values not.
struct CalculationPlaces {
    std::vector<PointResult> points;
    std::vector<GridResult> grids;

    std::size_t size() const;
    /// Calls `visit(point)` for every place, in order.
    template <class Visit>
    void for_each(Visit&& visit) {
        for (PointResult& point : points) visit(point);
        for (GridResult& grid : grids)
            for (PointResult& point : grid.points) visit(point);
    }
};
CalculationPlaces places_of(const Scene& scene);

/// One receiver a place, on the mesh's face where it lies on one.
std::vector<Receiver> receivers_at(CalculationPlaces& places, const Mesh& mesh);

/// True inside a solid and on a surface where one stands on it: no light arrives there, whatever
/// the room is like.
bool is_covered(const OccluderSet& occluders, const Vec3& position, const Vec3& normal);

/// What the parts of a value at one place are made from, lx.
struct ValueParts {
    double direct = 0.0;
    double interreflected = 0.0;
    double iteration = 0.0;  ///< gathered from the exitances' half widths
    double coarse = -1.0;    ///< the coarser solution's interreflected value; negative: not computed
    double misplaced = 0.0;  ///< what elements may misplace that both resolutions have alike (finer_mesh.h)
    double typical_mesh_error = 0.0;
    double reflected_error = 0.0;  ///< share of the interreflected value
    double skipped = 0.0;
    double sampling = 0.0;  ///< by how much the direct light may be off
};
/// Mesh part: 1.6 times the difference of the two resolutions, and at least 0.6 of its root mean square
/// over all points, so that two curves that happen to cross do not claim to be exact, and at least what is
/// misplaced alike by both; and what scaling to closure and the direct light of patches may have misplaced.
PointValue value_from(const ValueParts& parts);

/// Means over patches of what arrives, lx.
struct PatchLight {
    std::vector<double> direct, interreflected;
};

/// Area means of every face of the mesh.
std::map<SurfaceRef, PointValue> face_means(const Mesh& mesh, const PatchLight& light, double skipped_lux);

/// Where the flux goes. A room is closed: direct light that met nothing is an imbalance there, and has
/// escaped from a scene of surfaces alone. Of light between surfaces `account` tells all; without one
/// what is reflected was not followed. `from_luminaires` is their flux as the scene sets it (lm), of which
/// they take `on_luminaires` from each other.
EnergyBalance energy_of(const Scene& scene, const FluxAccount& account, double from_luminaires, double on_luminaires);

}  // namespace hanei
