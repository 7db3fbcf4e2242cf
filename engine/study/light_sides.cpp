#include "engine/study/light_sides.h"

#include "engine/transport/ambient.h"

#include <algorithm>

namespace hanei {

namespace {

/// A side as it is solved: with `gain` on all light that passes between surfaces, which is a gain on
/// reflectances where direct light has had it taken off.
struct Solved {
    std::vector<double> reflectance, direct, own_exitance;
    double gain = 1.0;

    LightSide side(const SideLight* before, bool same_rows) const {
        LightSide made{reflectance, direct, own_exitance, {}, {}};
        if (!before) return made;
        made.guess = before->sent;
        if (same_rows) made.guess_arriving = before->arrived;
        return made;
    }
    void set_gain(double wished) {
        gain = wished;
        for (double& value : reflectance) value *= gain;
        for (double& lux : direct) lux /= gain;
    }
};

/// Gives each side the gain with which as much light arrives as left: rows taken at nodes gain or lose
/// some of it. Told from an estimate of all exitance: it must not hang on how far the balance went.
/// False when stopped.
bool scale(std::span<Solved* const> sides, const SurfaceExchange& surfaces) {
    constexpr int looks = 2;  // by the ambient estimate, then by one reflection of that
    const std::size_t count = surfaces.areas.size();
    std::vector<double> leaving(count * sides.size()), arriving(leaving.size());
    std::vector<double> gains(sides.size(), 1.0);
    for (std::size_t s = 0; s < sides.size(); ++s) {
        const Solved& side = *sides[s];
        const double ambient = ambient_illuminance(surfaces.areas, side.reflectance, side.own_exitance, side.direct);
        for (std::size_t k = 0; k < count; ++k) arriving[k * sides.size() + s] = ambient;
    }
    for (int look = 0; look < looks; ++look) {
        std::vector<double> sent(sides.size(), 0.0), received(sides.size(), 0.0), greatest(sides.size(), 0.0);
        for (std::size_t k = 0; k < count; ++k) {
            for (std::size_t s = 0; s < sides.size(); ++s) {
                const Solved& side = *sides[s];
                const double lux = side.direct[k] + gains[s] * arriving[k * sides.size() + s];
                const double exitance = side.own_exitance[k] + side.reflectance[k] * lux;
                leaving[k * sides.size() + s] = exitance;
                sent[s] += surfaces.areas[k] * exitance * surfaces.row_sums[k];
                greatest[s] = std::max(greatest[s], side.reflectance[k] * surfaces.row_sums[k]);
            }
        }
        if (!surfaces.exchange(leaving, arriving, sides.size())) return false;
        for (std::size_t k = 0; k < count; ++k)
            for (std::size_t s = 0; s < sides.size(); ++s)
                received[s] += surfaces.areas[k] * arriving[k * sides.size() + s];
        for (std::size_t s = 0; s < sides.size(); ++s) {
            // never so much that light would grow from reflection to reflection
            const double most = 1.0 + 0.5 * std::max(0.0, 1.0 - greatest[s]);
            if (received[s] > 0.0) gains[s] = std::clamp(sent[s] / received[s], 0.5, most);
        }
    }
    for (std::size_t s = 0; s < sides.size(); ++s) sides[s]->set_gain(gains[s]);
    return true;
}

std::shared_ptr<const SideLight> side_light(std::vector<double> direct, const Solved& solved, Balance balance) {
    auto light = std::make_shared<SideLight>();
    light->direct = std::move(direct);
    light->interreflected = std::move(balance.interreflected);
    for (double& lux : light->interreflected) lux *= solved.gain;
    light->exitance = std::move(balance.exitance);
    light->exitance_half_width = std::move(balance.exitance_half_width);
    light->sent = std::move(balance.sent);
    light->arrived = std::move(balance.arrived);
    light->gain = solved.gain;
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
                                                                             const SurfaceExchange& surfaces, bool warm,
                                                                             const Work& work) {
    struct Wanted {
        std::size_t number;
        std::vector<double> direct;
        Solved solved;
        std::shared_ptr<const SideLight> before;
        bool same_rows = false;
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
        Wanted& side = wanted.emplace_back(Wanted{n, input.direct_sum(), {}, nullptr, false});
        side.solved.own_exitance = input.own_exitance;
        if (input.own_exitance.empty()) side.solved.own_exitance.assign(side.direct.size(), 0.0);
        if (warm && found != kept_.end() && found->second.light->sent.size() == side.direct.size()) {
            side.before = found->second.light;
            side.same_rows = found->second.input.rows == input.rows;
        }
        side.solved.reflectance = input.reflectance;
        side.solved.direct = side.direct;
        if (side.same_rows) side.solved.set_gain(side.before->gain);
    }
    reused_ = wanted.empty();
    if (reused_) return lights;

    std::vector<Solved*> unscaled;
    for (Wanted& side : wanted)
        if (surfaces.conserves && !side.same_rows) unscaled.push_back(&side.solved);
    if (!unscaled.empty() && !scale(unscaled, surfaces)) return std::nullopt;

    std::vector<LightSide> sides;
    for (const Wanted& side : wanted) sides.push_back(side.solved.side(side.before.get(), side.same_rows));
    auto balances = balance(surfaces.exchange, sides.front().direct.size(), sides, inputs.front().limits, work);
    if (!balances) return std::nullopt;
    for (std::size_t s = 0; s < wanted.size(); ++s) {
        Wanted& side = wanted[s];
        lights[side.number] = side_light(std::move(side.direct), side.solved, std::move((*balances)[s]));
        const SideInput& input = inputs[side.number];
        kept_.insert_or_assign(input.name, Kept{input, lights[side.number], side.before != nullptr});
    }
    return lights;
}

void LightSides::forget_others(std::span<const std::pair<ObjectId, int>> names) {
    std::erase_if(kept_,
                  [&](const auto& entry) { return std::find(names.begin(), names.end(), entry.first) == names.end(); });
}

}  // namespace hanei
