/// Two solutions compared place by place: what there is more and less of in the second.
#pragma once

#include "ui/view/view_options.h"

#include <optional>

namespace hanei {

/// Stands at vertices of which the first solution has no surface: everything above is "nothing to compare".
inline constexpr float no_counterpart = 1e30F;
constexpr bool has_counterpart(double lux) { return lux < 1e20; }

/// The light of a solution at places near its surfaces.
///
/// Needs     a solution with a mesh and a display mesh, which it borrows.
/// Cost      1 us a cell to make, a microsecond a place.
class SurfaceSampler {
public:
    explicit SurfaceSampler(const Solution& solution);
    ~SurfaceSampler();
    SurfaceSampler(const SurfaceSampler&) = delete;
    SurfaceSampler& operator=(const SurfaceSampler&) = delete;

    struct Light {
        double direct = 0.0, interreflected = 0.0, unshadowed = 0.0;  ///< lx
    };
    /// On the nearest surface within 3 cm that faces the same way; empty where there is none.
    std::optional<Light> at(const Vec3& place, const Vec3& normal) const;

private:
    struct Cells;
    std::unique_ptr<const Cells> cells_;
};

/// The second solution with "second minus first" in place of its light: at the vertices of its picture,
/// and at the points and grids that both report at the same places. The rest of it is as it was.
///
/// Needs     both complete, with display meshes. Geometry may differ.
SolutionSnapshot difference_of(const Solution& first, const Solution& second);

/// A round figure above nearly all (99 of 100) of the area's differences of this part; 1 lx at least.
double suggested_difference(const Solution& difference, LightPart part);

/// A grid that both report, by its id or else its name.
struct GridDifference {
    ObjectId grid;  ///< in the second
    std::string name;
    std::optional<GridFigures> first, second;
};
std::vector<GridDifference> compared_grids(const Solution& first, const Solution& second);

}  // namespace hanei
