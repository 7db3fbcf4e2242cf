#include "engine/transport/ambient.h"

#include "engine/base/check.h"
#include "engine/transport/sums.h"

namespace hanei {

double ambient_illuminance(std::span<const double> areas, std::span<const double> reflectance,
                           std::span<const double> own_exitance, std::span<const double> direct) {
    constexpr double least_absorbed = 1e-6;  // of all light: an estimate beyond a million reflections is none
    const std::size_t count = areas.size();
    HANEI_CHECK(reflectance.size() == count && own_exitance.size() == count && direct.size() == count);
    const double area = sum_of(count, [&](std::size_t k) { return areas[k]; });
    const double absorbing = sum_of(count, [&](std::size_t k) { return areas[k] * (1.0 - reflectance[k]); });
    if (area <= 0.0 || absorbing <= least_absorbed * area) return 0.0;
    const double emitted =
        sum_of(count, [&](std::size_t k) { return areas[k] * (own_exitance[k] + reflectance[k] * direct[k]); });
    return emitted / absorbing;
}

}  // namespace hanei
