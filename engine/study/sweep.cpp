#include "engine/study/sweep.h"

#include "engine/study/study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace hanei {

namespace {

/// A value that is compared, and the set it counts for. `lux` is below 0 inside solids.
struct Compared {
    double lux = 0.0;
    std::string set;
};

double lux_of(const PointResult& point) { return point.value.inside_solid ? -1.0 : point.value.total().value; }

std::vector<Compared> values_of(const Solution& solution, const SweepExpected* expected) {
    std::vector<Compared> values;
    for (std::size_t k = 0; k < solution.points.size(); ++k)
        values.push_back({lux_of(solution.points[k]), expected ? expected->sets[k] : "points"});
    for (std::size_t g = 0; g < solution.grids.size(); ++g) {
        const std::string& name = solution.scene->grids[g].name;
        for (const PointResult& point : solution.grids[g].points)
            values.push_back({lux_of(point), name.empty() ? fmt::format("grid {}", g + 1) : name});
    }
    return values;
}

SweepErrors errors_of(const std::string& set, const std::vector<Compared>& got, const std::vector<Compared>& expected,
                      const std::vector<std::size_t>& which) {
    double mean = 0.0;
    for (const std::size_t k : which) mean += expected[k].lux / static_cast<double>(which.size());
    SweepErrors errors{set, 0.0, 0.0, 0.0};
    std::vector<double> shares;
    for (const std::size_t k : which) {
        const double of = std::max(expected[k].lux, 0.1 * mean);
        shares.push_back(of > 0.0 ? std::abs(std::max(0.0, got[k].lux) - expected[k].lux) / of : 0.0);
    }
    if (shares.empty()) return errors;
    std::sort(shares.begin(), shares.end());
    for (const double share : shares) errors.mean += share / static_cast<double>(shares.size());
    errors.p95 = shares[std::min(shares.size() - 1, shares.size() * 95 / 100)];
    errors.max = shares.back();
    return errors;
}

std::vector<SweepErrors> errors_by_set(const std::vector<Compared>& got, const std::vector<Compared>& expected) {
    std::vector<std::size_t> all;
    std::map<std::string, std::vector<std::size_t>> sets;
    for (std::size_t k = 0; k < expected.size(); ++k) {
        if (expected[k].lux < 0.0) continue;
        all.push_back(k);
        sets[expected[k].set].push_back(k);
    }
    std::vector<SweepErrors> errors{errors_of("all", got, expected, all)};
    if (sets.size() == 1) return errors;
    for (const auto& [set, which] : sets) errors.push_back(errors_of(set, got, expected, which));
    return errors;
}

struct Timed {
    SolutionSnapshot solution;
    double milliseconds = 0.0;
};

/// Short runs are repeated, so that what else the machine does hardly counts.
Timed timed_run(const SceneSnapshot& scene, const Settings& settings, const Work& work) {
    constexpr int most_runs = 5;
    constexpr double long_enough = 400.0;  // ms
    Timed timed;
    double spent = 0.0;
    for (int k = 0; k < most_runs && spent < long_enough; ++k) {
        Study study;  // a new one: nothing is reused
        const auto begin = std::chrono::steady_clock::now();
        timed.solution = study.run(scene, settings, StudyRequest{.mesh_error = false}, work);
        if (!timed.solution) return timed;
        const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
        timed.milliseconds = k == 0 ? ms : std::min(timed.milliseconds, ms);
        spent += ms;
    }
    return timed;
}

/// The paper ends after a fixed number of interreflections; between close patches more would only grow.
constexpr int bounces_of_the_paper = 10;

/// Of a linear patch with its four unknowns, so that methods have about as many.
double width_of(Method method, double width) { return method == Method::linear ? 2.0 * width : width; }

}  // namespace

Sweep accuracy_sweep(const SceneSnapshot& scene, const Settings& settings, const SweepExpected* expected,
                     const Work& work) {
    constexpr double widths[] = {4.0, 2.0, 1.0, 0.5};  // times the patch width set
    Sweep sweep;
    std::vector<Compared> truth;
    if (expected) {
        sweep.against = expected->source;
        for (std::size_t k = 0; k < expected->lux.size(); ++k) truth.push_back({expected->lux[k], expected->sets[k]});
    } else {
        Settings fine = settings;
        fine.method = Method::linear;
        fine.bounces = std::max(settings.bounces, 1000);
        fine.accuracy = std::min(settings.accuracy, 1e-5);
        fine.max_patch = widths[3] * settings.max_patch;
        const auto finest = Study().run(scene, fine, StudyRequest{.mesh_error = false}, work);
        if (!finest) return sweep;
        sweep.against = fmt::format("the finest run (linear, patches of {:.3g} m)", fine.max_patch);
        truth = values_of(*finest, nullptr);
    }
    for (const Method method : methods) {
        for (const double width : widths) {
            Settings run = settings;
            run.method = method;
            run.max_patch = width_of(method, width * settings.max_patch);
            if (method == Method::paper) run.bounces = std::min(run.bounces, bounces_of_the_paper);
            const Timed timed = timed_run(scene, run, work);
            if (!timed.solution) return sweep;
            const Mesh& mesh = *timed.solution->mesh;
            SweepPoint& point = sweep.points.emplace_back();
            point.method = method;
            point.max_patch = run.max_patch;
            point.unknowns = is_of_the_paper(method) ? mesh.vertices.size() : timed.solution->exitance.size();
            point.milliseconds = timed.milliseconds;
            point.errors = errors_by_set(values_of(*timed.solution, expected), truth);
        }
    }
    return sweep;
}

}  // namespace hanei
