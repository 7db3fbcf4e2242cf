#include "engine/study/study.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace hanei {

namespace {

std::vector<double> values_of(const Solution& solution) {
    std::vector<double> values;
    for (const PointResult& point : solution.points)
        if (!point.value.inside_solid) values.push_back(point.value.total().value);
    for (const GridResult& grid : solution.grids)
        for (const PointResult& point : grid.points)
            if (!point.value.inside_solid) values.push_back(point.value.total().value);
    return values;
}

struct Timed {
    SolutionSnapshot solution;
    double milliseconds = 0.0;
};

Timed timed_run(const SceneSnapshot& scene, const Settings& settings, const Work& work) {
    Study study;  // a new one: nothing is reused, the time is that of a cold start
    const auto begin = std::chrono::steady_clock::now();
    Timed timed{study.run(scene, settings, StudyRequest{.mesh_error = false}, work), 0.0};
    timed.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    return timed;
}

void set_errors(SweepPoint& point, std::vector<double> values, const std::vector<double>& reference) {
    double mean = 0.0;
    for (const double lux : reference) mean += lux / static_cast<double>(reference.size());
    std::vector<double> errors;
    for (std::size_t k = 0; k < values.size(); ++k)
        errors.push_back(mean > 0.0 ? std::abs(values[k] - reference[k]) / mean : 0.0);
    if (errors.empty()) return;
    std::sort(errors.begin(), errors.end());
    for (const double error : errors) point.mean_error += error / static_cast<double>(errors.size());
    point.p95_error = errors[std::min(errors.size() - 1, errors.size() * 95 / 100)];
    point.max_error = errors.back();
}

}  // namespace

std::vector<SweepPoint> accuracy_sweep(SceneSnapshot scene, const Settings& settings, const Work& work) {
    constexpr double widths[] = {4.0, 2.0, 1.0, 0.5};  // times the patch width set
    constexpr double finest = 0.35;
    Settings fine = settings;
    fine.method = Method::patch;
    fine.bounces = std::max(settings.bounces, 1000);
    fine.accuracy = std::min(settings.accuracy, 1e-5);
    fine.max_patch = finest * settings.max_patch;
    const Timed reference = timed_run(scene, fine, work);
    if (!reference.solution) return {};
    const std::vector<double> expected = values_of(*reference.solution);

    std::vector<SweepPoint> points;
    for (const Method method : methods) {
        for (const double width : widths) {
            Settings run = settings;
            run.method = method;
            run.max_patch = width * settings.max_patch;
            const Timed timed = timed_run(scene, run, work);
            if (!timed.solution) return points;
            SweepPoint point;
            point.method = method;
            point.max_patch = run.max_patch;
            const Mesh& mesh = *timed.solution->mesh;
            point.unknowns = is_of_the_paper(method) ? mesh.vertices.size() : timed.solution->exitance.size();
            point.milliseconds = timed.milliseconds;
            set_errors(point, values_of(*timed.solution), expected);
            points.push_back(point);
        }
    }
    return points;
}

}  // namespace hanei
