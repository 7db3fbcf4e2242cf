#include "engine/direct/point_source.h"

#include <algorithm>
#include <cmath>

namespace hanei {

double PointSource::candela(const Vec3& direction) const {
    if (std::holds_alternative<Diffuse>(shape_)) return full_;
    const Vec3 local = direction * placed_.rotation;  // a row times a rotation: its inverse
    if (const auto* beam = std::get_if<CosinePower>(&shape_)) {
        return local.z < 0.0 ? full_ * std::pow(-local.z, beam->exponent) : 0.0;
    }
    return full_ * std::get<IntensityTable>(shape_).candela(local);
}

std::optional<NarrowBeam> PointSource::narrow_beam() const {
    constexpr double least_exponent = 100.0;  // half of the intensity 7 degrees off the axis
    const auto* const beam = std::get_if<CosinePower>(&shape_);
    if (beam == nullptr || beam->exponent < least_exponent) return std::nullopt;
    // acos of a figure next to 1, without the digits that it would lose
    const double less = -std::expm1(-std::log(2.0) / beam->exponent);
    return NarrowBeam{placed_.position, front(), 2.0 * std::asin(std::sqrt(0.5 * less))};
}

double PointSource::unobstructed(const Receiver& receiver) const {
    const Vec3 to_source = placed_.position - receiver.position;
    const double square = glm::dot(to_source, to_source);
    const double height = glm::dot(to_source, receiver.normal);
    if (!(height > 0.0) || !(square > 0.0)) return 0.0;
    const double distance = std::sqrt(square);
    return candela(-to_source / distance) * height / (square * distance);
}

}  // namespace hanei
