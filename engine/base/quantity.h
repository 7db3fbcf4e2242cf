/// Photometric quantities with the kind in the type, so that arriving and leaving light cannot be
/// mixed up. Words as in the CIE International Lighting Vocabulary (CIE S 017).
#pragma once

#include <compare>

namespace hanei {

template <class Kind>
struct Quantity {
    double value = 0.0;

    auto operator<=>(const Quantity&) const = default;
    constexpr Quantity operator+(Quantity other) const { return {value + other.value}; }
    constexpr Quantity operator-(Quantity other) const { return {value - other.value}; }
    constexpr Quantity operator*(double factor) const { return {value * factor}; }
    constexpr Quantity operator/(double divisor) const { return {value / divisor}; }
    constexpr double operator/(Quantity other) const { return value / other.value; }
    constexpr Quantity& operator+=(Quantity other) {
        value += other.value;
        return *this;
    }
};

template <class Kind>
constexpr Quantity<Kind> operator*(double factor, Quantity<Kind> quantity) {
    return quantity * factor;
}

using Illuminance = Quantity<struct IlluminanceKind>;              ///< lx, arriving
using LuminousExitance = Quantity<struct LuminousExitanceKind>;    ///< lm/m2, leaving
using LuminousFlux = Quantity<struct LuminousFluxKind>;            ///< lm
using LuminousIntensity = Quantity<struct LuminousIntensityKind>;  ///< cd
using Luminance = Quantity<struct LuminanceKind>;                  ///< cd/m2

/// Light leaving a perfectly diffuse surface for the light arriving at it.
constexpr LuminousExitance reflected(Illuminance arriving, double reflectance) {
    return {reflectance * arriving.value};
}

}  // namespace hanei
