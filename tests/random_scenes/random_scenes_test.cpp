/// The whole engine over scenes that nobody would draw.
///
/// HANEI_FUZZ_SCENES   how many (the seeds from HANEI_FUZZ_FIRST on); each seed is then told on stderr
///                     before it runs, so that a crash or a hang can be laid at its door.
/// HANEI_FUZZ_KEEP     a folder: every scene is written there as a project first.
#include "engine/project/project_file.h"
#include "engine/scene/scene_check.h"
#include "engine/study/study.h"
#include "tests/box_room.h"
#include "tests/random_scene.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <gtest/gtest.h>
#include <mutex>
#include <thread>
#include <utility>

namespace hanei {
namespace {

std::uint64_t figure_of(const char* name, std::uint64_t usual) {
    const char* wanted = std::getenv(name);
    return wanted == nullptr ? usual : std::strtoull(wanted, nullptr, 10);
}
std::uint64_t first_seed() { return figure_of("HANEI_FUZZ_FIRST", 1); }
std::uint64_t scene_count(std::uint64_t usual) { return figure_of("HANEI_FUZZ_SCENES", usual); }

void announce(std::uint64_t seed) {
    if (std::getenv("HANEI_FUZZ_SCENES") != nullptr) std::fprintf(stderr, "\rscene %llu ", (unsigned long long)seed);
}

void keep(std::uint64_t seed, const Scene& scene, const Settings& settings) {
    const char* const folder = std::getenv("HANEI_FUZZ_KEEP");
    if (folder != nullptr)
        write_project({scene, settings}, std::filesystem::path(folder) / (std::to_string(seed) + ".hanei"));
}

/// Stops a study that does not end by itself within the work that no such scene needs: CPU time, which a
/// busy machine does not stretch.
class WorkLimit {
public:
    std::stop_token token() const { return source_.get_token(); }
    ~WorkLimit() {
        {
            const std::lock_guard lock(mutex_);
            ended_ = true;
        }
        change_.notify_all();
    }

private:
    void watch() {
        const double most = static_cast<double>(std::clock()) +
                            CLOCKS_PER_SEC * static_cast<double>(figure_of("HANEI_FUZZ_SECONDS", 300));
        std::unique_lock lock(mutex_);
        while (!change_.wait_for(lock, std::chrono::milliseconds(100), [this] { return ended_; }))
            if (static_cast<double>(std::clock()) > most) source_.request_stop();
    }

    std::stop_source source_;
    std::mutex mutex_;
    std::condition_variable change_;
    bool ended_ = false;
    std::jthread watch_{[this] { watch(); }};
};

SolutionSnapshot solve(const Scene& scene, const Settings& settings, const StudyRequest& request) {
    const WorkLimit limit;
    return Study().run(std::make_shared<const Scene>(scene), settings, request,
                       {.threads = settings.threads, .stop = limit.token()});
}

StudyRequest random_request(std::uint64_t seed) {
    test::Dice dice(seed ^ 0x51U);
    StudyRequest request{.energy = true};
    request.display = dice.chance(0.2);
    request.unshadowed = request.display && dice.chance(0.5);
    request.shadows = dice.chance(0.1);
    request.mesh_error = dice.chance(0.7);
    request.refine = dice.chance(0.7);
    return request;
}

std::vector<PointResult> all_points(const Solution& solution) {
    std::vector<PointResult> all = solution.points;
    for (const GridResult& grid : solution.grids) all.insert(all.end(), grid.points.begin(), grid.points.end());
    return all;
}

bool sound(double figure) { return std::isfinite(figure) && figure >= 0.0; }

std::string what_of(const PointResult& point) {
    return "at (" + std::to_string(point.position.x) + ", " + std::to_string(point.position.y) + ", " +
           std::to_string(point.position.z) + "): " + std::to_string(point.value.direct.value) + " + " +
           std::to_string(point.value.interreflected.value) + " lx, +- " + std::to_string(point.value.error.total());
}

void expect_sound(const Solution& solution) {
    for (const PointResult& point : all_points(solution)) {
        const ErrorBar& error = point.value.error;
        for (const double lux : {point.value.direct.value, point.value.interreflected.value, error.iteration,
                                 error.mesh, error.skipped, error.sampling})
            EXPECT_TRUE(sound(lux)) << what_of(point);
    }
    const std::pair<const char*, const std::vector<double>*> lists[] = {
        {"exitance", &solution.exitance},
        {"half width", &solution.exitance_half_width},
        {"direct", &solution.patch_direct},
        {"interreflected", &solution.patch_interreflected},
        {"coarse exitance", &solution.coarse_exitance}};
    for (const auto& [name, list] : lists) {
        const auto broken = std::find_if_not(list->begin(), list->end(), sound);
        EXPECT_EQ(broken, list->end()) << name << " of patch " << broken - list->begin() << ": " << *broken;
    }
    for (const auto& [face, mean] : solution.face_means)
        EXPECT_TRUE(sound(mean.total().value) && sound(mean.error.total()));
    if (solution.display) {
        const auto& vertices = solution.display->vertices;
        const auto broken = std::find_if_not(vertices.begin(), vertices.end(), [](const DisplayVertex& vertex) {
            return sound(vertex.direct) && sound(vertex.interreflected) && sound(vertex.unshadowed);
        });
        EXPECT_EQ(broken, vertices.end()) << broken->direct << " + " << broken->interreflected << " lx, "
                                          << broken->unshadowed << " lx without shadows";
    }
    const EnergyBalance& energy = solution.energy;
    for (const double lumen : {energy.emitted, energy.absorbed, energy.on_luminaires, energy.escaped})
        EXPECT_TRUE(sound(lumen)) << lumen << " lm";
}

/// Interreflected light is a mean of exitances over directions: nowhere more than the brightest of them.
/// A linear patch may slope past its nodes.
void expect_no_more_than_all_light(const Solution& solution) {
    if (is_of_the_paper(solution.settings.method) || solution.exitance.empty()) return;
    double brightest = *std::max_element(solution.exitance.begin(), solution.exitance.end());
    if (solution.settings.method == Method::linear) brightest *= 1.5;
    for (const PointResult& point : all_points(solution))
        EXPECT_LE(point.value.interreflected.value, brightest * (1.0 + 1e-6) + point.value.error.total())
            << what_of(point);
}

/// What surfaces absorb and what gets out is what was emitted, but for what direct light on patches and the
/// iteration leave open.
void expect_balanced_flux(const Solution& solution) {
    if (is_of_the_paper(solution.settings.method) || !solution.refusal.empty() || !solution.converged) return;
    if (solution.settings.tolerance_lux > 0.0) return;  // what is skipped is not counted
    const double open = 0.02 + 2.0 * solution.settings.accuracy;
    EXPECT_LE(std::abs(solution.energy.imbalance()), open * solution.energy.emitted)
        << solution.energy.emitted << " lm emitted, " << solution.energy.absorbed << " absorbed, "
        << solution.energy.on_luminaires << " on luminaires, " << solution.energy.escaped << " escaped";
}

/// The study of every scene that was asked for, with its seed told where one fails.
void for_each_scene(std::uint64_t usual, Scene (*draw)(std::uint64_t),
                    const std::function<void(const Solution&)>& judge) {
    for (std::uint64_t seed = first_seed(), end = seed + scene_count(usual); seed < end; ++seed) {
        announce(seed);
        const Scene scene = draw(seed);
        const Settings settings = test::random_settings(seed, scene);
        keep(seed, scene, settings);
        SCOPED_TRACE("scene " + std::to_string(seed) + " by " + std::string(name_of(settings.method)));
        const SolutionSnapshot solution = solve(scene, settings, random_request(seed));
        EXPECT_TRUE(solution) << "the study did not end";
        if (solution) judge(*solution);
    }
}

TEST(RandomScenes, give_sound_figures) {
    for_each_scene(15, test::random_scene, [](const Solution& solution) {
        expect_sound(solution);
        expect_no_more_than_all_light(solution);
    });
}

TEST(RandomScenes, keep_the_flux_of_luminaires_that_hang_free) {
    for_each_scene(25, test::random_scene_of_free_luminaires, [](const Solution& solution) {
        expect_sound(solution);
        expect_balanced_flux(solution);
    });
}

/// Found by chance: rounding left a node that hardly anything reaches 1e-17 lx below none.
TEST(RandomScenes, nodes_in_the_dark_send_no_negative_light) {
    constexpr std::uint64_t seed = 2977;
    const Scene scene = test::random_scene(seed);
    expect_sound(*solve(scene, test::random_settings(seed, scene), random_request(seed)));
}

/// Found by chance: the paper's form factors across such a gap, multiplied bounce by bounce, pass what a
/// float of the picture holds.
TEST(RandomScenes, a_gap_of_a_nanometre_keeps_the_papers_picture_finite) {
    Scene scene = test::box_room({3.0, 2.4, 2.5}, 0.6);
    scene.luminaires.push_back(test::panel(scene, {1.4, 1.1, 2.4}, {0.8, 0.4}, 3000.0));
    scene.furniture = {test::box(scene, {1.0, 1.2, 0.0}, {0.6, 0.6, 0.8}),
                       test::box(scene, {1.6 + 1e-9, 1.2, 0.0}, {0.6, 0.6, 0.8})};
    scene.points = {test::point(scene, {1.3, 0.5, 0.0})};
    Settings settings;
    settings.method = Method::paper;
    settings.bounces = 4;
    expect_sound(*solve(scene, settings, {.display = true, .energy = true}));
}

}  // namespace
}  // namespace hanei
