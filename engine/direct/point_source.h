/// A luminaire small enough to be a point.
#pragma once

#include "engine/direct/intensity_table.h"
#include "engine/direct/narrow_beam.h"
#include "engine/geometry/configuration_factor.h"
#include "engine/scene/placement.h"
#include "engine/scene/scene.h"

#include <optional>
#include <variant>

namespace hanei {

/// Shines `full` candela all around, `full` cos^exponent below its horizon, or `full` times the
/// intensities of a table.
class PointSource {
public:
    PointSource(const Placement& placed, double exponent, double full)
        : placed_(placed), shape_(CosinePower{exponent}), full_(full) {}
    PointSource(const Placement& placed, double full) : placed_(placed), shape_(Diffuse{}), full_(full) {}
    PointSource(const Placement& placed, Photometry table, double full)
        : placed_(placed), shape_(IntensityTable(std::move(table))), full_(full) {}

    const Vec3& position() const { return placed_.position; }

    /// Nothing is radiated behind this; zero: it shines all around.
    Vec3 front() const { return std::holds_alternative<CosinePower>(shape_) ? -placed_.rotation[2] : Vec3{0.0}; }
    /// None of a beam that is not narrower than what nodes a few degrees apart notice, and of tables.
    std::optional<NarrowBeam> narrow_beam() const;
    bool is_dark() const { return !(full_ > 0.0); }

    /// Inverse square law, nothing in between; 0 at the source itself.
    double unobstructed(const Receiver& receiver) const;

private:
    double candela(const Vec3& direction) const;

    Placement placed_;
    std::variant<Diffuse, CosinePower, IntensityTable> shape_;
    double full_;
};

}  // namespace hanei
