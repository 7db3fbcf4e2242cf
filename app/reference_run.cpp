#include "app/reference_run.h"

#include "app/reference_scene.h"
#include "engine/scene/faces.h"
#include "engine/study/study.h"

#include <chrono>
#include <cmath>

namespace hanei {

namespace {

// Keep a case within some seconds.
constexpr double patches_aimed_at = 4000.0;         // one value each
constexpr double linear_patches_aimed_at = 250.0;   // four each, and cut finer where the light asks for it
constexpr std::size_t most_faces_for_linear = 400;  // each is a patch at least

/// The best method for the scene, and the patch width that cuts its faces into about as many as fit it.
void make_suitable(Settings& settings, const Scene& scene, const SettingsChange& change) {
    settings.method = faces_of(scene).size() <= most_faces_for_linear ? Method::linear : Method::patch;
    settings.accuracy = 1e-7;
    settings.bounces = 100'000;
    change(settings);
    const bool linear = settings.method == Method::linear;
    settings.max_patch = suitable_patch(scene, linear ? linear_patches_aimed_at : patches_aimed_at);
    change(settings);
}

double mean_of_face(const Solution& solution, ObjectId surface) {
    const auto found = solution.face_means.find(SurfaceRef{surface, 0});
    return found == solution.face_means.end() ? NAN : found->second.total().value;
}

std::vector<Judged> judged_points(const ReferenceCase& reference, const Solution& solution) {
    std::vector<Judged> judged;
    for (std::size_t k = 0; k < reference.points.size(); ++k) {
        const ReferencePoint& point = reference.points[k];
        const PointValue& value = solution.points[k].value;
        judged.push_back(
            judge(point.id, point.set, point.expected, value.total().value, point.uncertainty, point.top, point.pass));
        judged.back().error_bar = value.error.total();
    }
    for (const ReferenceMean& mean : reference.means) {
        const double got = mean.surface ? mean_of_face(solution, mean.surface) : mean_illuminance(solution);
        judged.push_back(judge("mean of " + mean.name, "", mean.expected, got, mean.uncertainty, mean.top, mean.pass));
    }
    return judged;
}

std::vector<Judged> judged_form_factors(const ReferenceCase& reference) {
    std::vector<Judged> judged;
    for (const ReferenceFormFactor& pair : reference.form_factors) {
        const auto add = [&](const std::string& id, const Region& from, const Region& to, double expected) {
            const double got = form_factor_between(reference.scene, from, to);
            judged.push_back(judge(id, "", expected, got, pair.uncertainty, pair.top, pair.pass));
        };
        add(pair.id, pair.from, pair.to, pair.expected);
        if (pair.reverse) add(pair.id + " reverse", pair.to, pair.from, *pair.reverse);
    }
    return judged;
}

}  // namespace

std::optional<CaseVerdict> run_reference(const ReferenceCase& reference, const SettingsChange& change,
                                         const Work& work) {
    CaseVerdict verdict{reference.id, reference.category, reference.unsupported, {}};
    if (!reference.unsupported.empty()) return verdict;
    Settings settings;
    make_suitable(settings, reference.scene, change);
    const auto begin = std::chrono::steady_clock::now();
    if (!reference.points.empty() || !reference.means.empty()) {
        Study study;
        const auto solution = study.run(scene_with_points(reference), settings, StudyRequest{}, work);
        if (!solution) return std::nullopt;
        verdict.judged = judged_points(reference, *solution);
        verdict.patches = solution->mesh->patches.size();
        verdict.method = name_of(settings.method);
    }
    for (Judged& pair : judged_form_factors(reference)) verdict.judged.push_back(std::move(pair));
    verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return verdict;
}

}  // namespace hanei
