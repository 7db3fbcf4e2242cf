/// Direct light of measured luminaires in a furnished room at the accuracy that is asked for: time a
/// receiver and luminaire, and how far off the light of all luminaires together truly is.
#include "engine/mesh/mesh.h"
#include "tests/bench/row.h"
#include "tests/box_room.h"
#include "tests/unit/direct/scenes.h"
#include "tests/unit/geometry/shapes.h"

#include <cmath>
#include <map>

namespace hanei::bench {

namespace {

constexpr double width = 1.2, depth = 0.3;  // of an opening, m

/// Six luminaires over twelve desks with their screens.
Scene furnished_room() {
    Scene scene = test::box_room({9.0, 6.0, 2.8}, 0.5);
    for (int k = 0; k < 12; ++k) {
        const double x = 1.0 + 1.4 * (k % 6), y = k < 6 ? 1.8 : 4.2;
        scene.furniture.push_back(test::box(scene, {x, y, 0.7}, {1.2, 0.8, 0.04}));
        scene.furniture.push_back(test::box(scene, {x, y + 0.43, 0.0}, {1.2, 0.04, 1.25}));
        scene.furniture.push_back(test::box(scene, {x - 0.5, y, 0.0}, {0.1, 0.6, 0.7}));
    }
    const auto batwing = [](double gamma) { return 200.0 + 800.0 * std::pow(std::sin(2.0 * gamma), 2); };
    scene.photometries = {testing::table(batwing, 5.0, 90.0)};
    return scene;
}

/// The luminaires, each cut into `parts` x `parts` that are so much smaller.
std::vector<Emitter> emitters_in(const Scene& scene, int parts) {
    std::vector<Emitter> emitters;
    for (int k = 0; k < 6 * parts * parts; ++k) {
        const int whole = k / (parts * parts), u = k % parts, v = k / parts % parts;
        const Vec3 at{1.5 + 3.0 * (whole % 3) + width * ((u + 0.5) / parts - 0.5),
                      1.5 + 3.0 * (whole / 3) + depth * ((v + 0.5) / parts - 0.5), 2.7};
        Luminaire luminaire = testing::luminaire_at(at, testing::panel(width / parts, depth / parts),
                                                    LuminousFlux{3000.0 / (parts * parts)});
        luminaire.id = ObjectId{1'000'000};
        luminaire.distribution = Measured{ObjectId{3}};
        emitters.emplace_back(scene, luminaire);
    }
    return emitters;
}

struct Office {
    Scene scene = furnished_room();
    std::shared_ptr<const Mesh> mesh = make_mesh(scene, 0.5);
    OccluderSet occluders = occluders_of(scene);
    std::vector<Emitter> emitters = emitters_in(scene, 1);
    std::vector<ReceivingPolygon> polygons;
    std::vector<Receiver> points;

    Office() {
        for (const Patch& patch : mesh->patches)
            polygons.push_back({patch.outline, mesh->faces[patch.face].face.normal});
        for (int k = 0; k < 54 * 36; ++k)
            points.push_back({{(k % 54 + 0.5) / 6.0, (k / 54 + 0.5) / 6.0, 0.76}, {0, 0, 1}, Vec3{0}});
    }

    /// The light of all emitters on every patch or point.
    std::vector<double> light(std::span<const Emitter> from, const Accuracy& accuracy, bool on_patches) const {
        std::vector<double> sum(on_patches ? polygons.size() : points.size(), 0.0);
        for (const Emitter& emitter : from) {
            const auto part = on_patches ? mean_direct_estimates(emitter, polygons, &occluders, accuracy, {})
                                         : direct_estimates(emitter, points, &occluders, accuracy, {});
            for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += (*part)[k];
        }
        return sum;
    }
};

const Office& office() {
    static const Office made;
    return made;
}

/// By luminaires cut into sixteen, each worked out to the finest.
const std::vector<double>& truth(bool on_patches) {
    static std::map<bool, std::vector<double>> made;
    std::vector<double>& values = made[on_patches];
    if (values.empty()) values = office().light(emitters_in(office().scene, 4), {}, on_patches);
    return values;
}

void measured(benchmark::State& state, bool on_patches) {
    const Office& room = office();
    const std::vector<double>& expected = truth(on_patches);
    double mean = 0.0;
    for (const double value : expected) mean += value / static_cast<double>(expected.size());
    const Accuracy accuracy = accuracy_of_each(1.0 / static_cast<double>(state.range(0)), mean, room.emitters.size());
    std::vector<double> got;
    const auto pairs = static_cast<benchmark::IterationCount>(expected.size() * room.emitters.size());
    while (state.KeepRunningBatch(pairs)) got = room.light(room.emitters, accuracy, on_patches);
    Row row;
    double squares = 0.0;
    row.error_max = 0.0;
    for (std::size_t k = 0; k < got.size(); ++k) {
        const double off = std::abs(got[k] - expected[k]) / mean;
        squares += off * off;
        row.error_max = std::max(row.error_max, off);
    }
    row.error_rms = std::sqrt(squares / static_cast<double>(got.size()));
    row.report(state);
}

/// One over the accuracy.
void accuracies(benchmark::internal::Benchmark* each) {
    each->ArgName("one_in")->Unit(benchmark::kMicrosecond);
    for (const int one_in : {100, 333, 1000, 10'000}) each->Arg(one_in);
}

BENCHMARK_CAPTURE(measured, , true)->Name("direct_means")->Apply(accuracies);
BENCHMARK_CAPTURE(measured, , false)->Name("direct_points")->Apply(accuracies);

}  // namespace

}  // namespace hanei::bench
