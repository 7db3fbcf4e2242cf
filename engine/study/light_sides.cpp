#include "engine/study/light_sides.h"

#include <algorithm>

namespace hanei {

namespace {

std::shared_ptr<const SideLight> side_light(std::vector<double> direct, Balance balance) {
    auto light = std::make_shared<SideLight>();
    light->direct = std::move(direct);
    light->interreflected = std::move(balance.interreflected);
    light->exitance = std::move(balance.exitance);
    light->exitance_half_width = std::move(balance.exitance_half_width);
    light->bounces = balance.bounces;
    light->converged = balance.converged;
    light->greatest_row_sum = balance.greatest_row_sum;
    return light;
}

}  // namespace

bool SideInput::operator==(const SideInput& other) const {
    return direct == other.direct && shares == other.shares && reflectance == other.reflectance &&
           own_exitance == other.own_exitance && rows == other.rows && limits.bounces == other.limits.bounces &&
           limits.accuracy == other.limits.accuracy;
}

std::vector<double> SideInput::direct_sum() const {
    std::vector<double> sum(reflectance.size(), 0.0);
    for (std::size_t m = 0; m < direct.size(); ++m)
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += shares[m] * (*direct[m])[k];
    return sum;
}

std::optional<std::vector<std::shared_ptr<const SideLight>>> LightSides::get(std::vector<SideInput> inputs,
                                                                             const Exchange& exchange, bool warm,
                                                                             const Work& work) {
    struct Wanted {
        std::size_t number;
        std::vector<double> direct, own_exitance;
        std::shared_ptr<const SideLight> before;
    };
    std::vector<std::shared_ptr<const SideLight>> lights(inputs.size());
    std::vector<Wanted> wanted;
    for (std::size_t n = 0; n < inputs.size(); ++n) {
        const SideInput& input = inputs[n];
        const auto found = kept_.find(input.name);
        if (found != kept_.end() && found->second.input == input && (warm || !found->second.is_warm)) {
            lights[n] = found->second.light;
            continue;
        }
        Wanted& side = wanted.emplace_back(Wanted{n, input.direct_sum(), input.own_exitance, nullptr});
        if (side.own_exitance.empty()) side.own_exitance.assign(side.direct.size(), 0.0);
        if (warm && found != kept_.end() && found->second.light->exitance.size() == side.direct.size())
            side.before = found->second.light;
    }
    reused_ = wanted.empty();
    if (reused_) return lights;

    std::vector<LightSide> sides;
    for (const Wanted& side : wanted) {
        LightSide& made = sides.emplace_back();
        made.reflectance = inputs[side.number].reflectance;
        made.direct = side.direct;
        made.own_exitance = side.own_exitance;
        if (side.before) made.guess = side.before->exitance;
    }
    const BalanceLimits& limits = inputs.front().limits;
    auto balances = balance(exchange, sides.front().direct.size(), sides, limits, work);
    if (!balances) return std::nullopt;
    for (std::size_t s = 0; s < wanted.size(); ++s) {
        SideInput& input = inputs[wanted[s].number];
        lights[wanted[s].number] = side_light(std::move(wanted[s].direct), std::move((*balances)[s]));
        kept_.insert_or_assign(input.name, Kept{input, lights[wanted[s].number], wanted[s].before != nullptr});
    }
    return lights;
}

void LightSides::forget_others(std::span<const std::pair<ObjectId, int>> names) {
    std::erase_if(kept_,
                  [&](const auto& entry) { return std::find(names.begin(), names.end(), entry.first) == names.end(); });
}

}  // namespace hanei
