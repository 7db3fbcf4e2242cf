/// How a luminaire's light reaches a patch: the paper's third step.
#pragma once

#include <cstdint>
#include <string_view>

namespace hanei {

/// Of a patch as a whole, towards one luminaire. Every class but `partly` is proved.
enum class LightClass : std::uint8_t {
    away,    ///< they do not face each other: unlit whatever stands between
    umbra,   ///< no point of the patch sees any of the opening: unlit
    partly,  ///< neither could be proved: there may be penumbra, or a shadow's edge
    lit      ///< every point sees all of the opening that is above its horizon
};

constexpr bool is_unlit(LightClass kind) { return kind == LightClass::away || kind == LightClass::umbra; }

/// Towards two sources at once: lit by those that face it, unlit by all, or partly.
constexpr LightClass together(LightClass a, LightClass b) {
    if (a == LightClass::away || a == b) return b;
    return b == LightClass::away ? a : LightClass::partly;
}

constexpr std::string_view name_of(LightClass kind) {
    return kind == LightClass::lit ? "lit" : kind == LightClass::partly ? "partly lit" : "unlit";
}

}  // namespace hanei
