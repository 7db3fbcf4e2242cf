#include "engine/transport/energy.h"

#include "engine/base/check.h"
#include "engine/transport/sums.h"

#include <algorithm>

namespace hanei {

FluxAccount account_of(const LightOnNodes& light) {
    const std::size_t count = light.areas.size();
    HANEI_CHECK(light.reflectance.size() == count && light.own_exitance.size() == count);
    HANEI_CHECK(light.direct.size() == count && light.interreflected.size() == count && light.row_sums.size() == count);

    const auto total = [&](auto&& of_area) {
        return sum_of(count, [&](std::size_t k) { return light.areas[k] * of_area(k); });
    };
    const auto arriving = [&](std::size_t k) { return light.direct[k] + light.interreflected[k]; };
    const auto leaving = [&](std::size_t k) { return light.own_exitance[k] + light.reflectance[k] * arriving(k); };
    const auto open = [&](std::size_t k) { return std::max(0.0, 1.0 - light.row_sums[k]); };

    FluxAccount account;
    account.own = total([&](std::size_t k) { return light.own_exitance[k]; });
    account.direct = total([&](std::size_t k) { return light.direct[k]; });
    account.absorbed = total([&](std::size_t k) { return (1.0 - light.reflectance[k]) * arriving(k); });
    account.escaped = total([&](std::size_t k) { return open(k) * leaving(k); });
    account.sent = total([&](std::size_t k) { return (1.0 - open(k)) * leaving(k); });
    account.received = total([&](std::size_t k) { return light.interreflected[k]; });
    return account;
}

}  // namespace hanei
