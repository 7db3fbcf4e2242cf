#include "tests/bench/settings.h"

#include "tests/unit/direct/scenes.h"
#include "tests/unit/geometry/shapes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace hanei::bench {

namespace {

using testing::Dice;

constexpr double ceiling = 2.8;

struct Floor {
    Vec2 low, high;
    Vec2 place(Dice& dice) const { return {dice.uniform(low.x, high.x), dice.uniform(low.y, high.y)}; }
};

ConvexBody turned_box(const Vec3& middle, const Vec3& size, const Mat3& turn) {
    ConvexBody body = testing::box_body(-0.5 * size, 0.5 * size);
    for (Vec3& vertex : body.vertices) vertex = middle + turn * vertex;
    return body;
}

std::vector<Receiver> receivers_outside(const OccluderSet& occluders, const Floor& floor, int count, Dice& dice) {
    std::vector<Receiver> receivers;
    while (static_cast<int>(receivers.size()) < count) {
        const double height = receivers.size() % 2 == 0 ? 0.0 : 0.75;
        const Receiver receiver{Vec3{floor.place(dice), height}, {0, 0, 1}, Vec3{0}};
        if (occluders.containing(receiver.position) < 0) receivers.push_back(receiver);
    }
    return receivers;
}

Setting made(std::vector<ConvexBody> bodies, const Floor& receiving, int receivers, Dice& dice) {
    Setting setting;
    setting.panels = {{2.0, 2.0, ceiling - 0.02}, {4.0, 2.0, ceiling - 0.02}};
    for (const Vec3& place : setting.panels) {
        setting.emitters.emplace_back(
            Scene{}, testing::luminaire_at(place, testing::panel(panel_width, panel_depth), Luminance{5000}));
    }
    setting.occluders = OccluderSet(std::move(bodies));
    setting.receivers = receivers_outside(setting.occluders, receiving, receivers, dice);
    setting.lights.resize(setting.pairs());
    const double share = 1.0 / static_cast<double>(setting.pairs());
    for (std::size_t pair = 0; pair < setting.pairs(); ++pair) {
        Light& light = setting.lights[pair];
        light.unobstructed = setting.emitter(pair).illuminance(setting.receiver(pair), nullptr).value;
        light.arriving = setting.emitter(pair).illuminance(setting.receiver(pair), &setting.occluders).value;
        setting.brightest = std::max(setting.brightest, light.unobstructed);
        const bool dark = light.arriving == 0.0, whole = light.arriving >= (1.0 - 1e-9) * light.unobstructed;
        (dark ? setting.umbra : whole ? setting.lit : setting.penumbra) += share;
    }
    return setting;
}

const Setting& kept(std::map<int, Setting>& settings, int count, Setting (*make)(int)) {
    const auto found = settings.find(count);
    return found != settings.end() ? found->second : settings.emplace(count, make(count)).first->second;
}

}  // namespace

const Setting& among_boxes(int count) {
    static std::map<int, Setting> settings;
    return kept(settings, count, [](int boxes) {
        Dice dice(static_cast<std::uint64_t>(1000 + boxes));
        const bool hall = boxes > 600;
        const double scale = hall ? std::sqrt(boxes / 150.0) : 1.0;
        const Vec2 middle{3.0, 2.0}, half = scale * Vec2{3.0, 2.0};
        const Floor floor{middle - half, middle + half};
        std::vector<ConvexBody> bodies;
        for (int k = 0; k < boxes; ++k) {
            const Vec3 place{floor.place(dice), dice.uniform(0.0, 1.8)};
            const Vec3 size{dice.uniform(0.1, 0.7), dice.uniform(0.1, 0.7), dice.uniform(0.1, 0.7)};
            bodies.push_back(turned_box(place, size, dice.rotation()));
        }
        const Floor receiving = hall ? Floor{{-1.0, -1.0}, {7.0, 5.0}} : floor;
        return made(std::move(bodies), receiving, 2000, dice);
    });
}

const Setting& among_sticks(int count) {
    static std::map<int, Setting> settings;
    return kept(settings, count, [](int sticks) {
        Dice dice(static_cast<std::uint64_t>(2000 + sticks));
        const Floor floor{{0.0, 0.0}, {6.0, 4.0}};
        std::vector<ConvexBody> bodies;
        for (int k = 0; k < sticks; ++k) {
            const Vec3 place{floor.place(dice), dice.uniform(0.8, 2.2)};
            bodies.push_back(turned_box(place, {1.0, 0.02, 0.02}, dice.rotation()));
        }
        return made(std::move(bodies), floor, 500, dice);
    });
}

}  // namespace hanei::bench
