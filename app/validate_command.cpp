#include "app/commands.h"
#include "app/exit_code.h"
#include "app/files.h"
#include "app/reference_scene.h"
#include "app/verdict.h"
#include "engine/scene/faces.h"
#include "engine/study/study.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

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

CaseVerdict run_case(const ReferenceCase& reference, const ValidateRequest& request) {
    CaseVerdict verdict{reference.id, reference.category, reference.unsupported, {}, 0.0, 0};
    if (!reference.unsupported.empty()) return verdict;
    Settings settings;
    make_suitable(settings, reference.scene, request.change);
    const auto begin = std::chrono::steady_clock::now();
    if (!reference.points.empty() || !reference.means.empty()) {
        Study study;
        const auto solution = study.run(scene_with_points(reference), settings, StudyRequest{}, Work{});
        verdict.judged = judged_points(reference, *solution);
        verdict.patches = solution->mesh->patches.size();
    }
    for (Judged& pair : judged_form_factors(reference)) verdict.judged.push_back(std::move(pair));
    verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return verdict;
}

nlohmann::ordered_json to_json(const CaseVerdict& verdict) {
    nlohmann::ordered_json json{{"case", verdict.id},
                                {"category", verdict.category},
                                {"grade", name_of(verdict.grade())},
                                {"seconds", verdict.seconds},
                                {"patches", verdict.patches}};
    if (!verdict.unsupported.empty()) json["unsupported"] = verdict.unsupported;
    json["points"] = nlohmann::ordered_json::array();
    for (const Judged& judged : verdict.judged) {
        json["points"].push_back({{"id", judged.id},
                                  {"set", judged.set},
                                  {"expected", judged.expected},
                                  {"got", judged.got},
                                  {"error", judged.got - judged.expected},
                                  {"allowed_top", judged.allowed_top},
                                  {"allowed_pass", judged.allowed_pass},
                                  {"error_bar", judged.error_bar},
                                  {"grade", name_of(judged.grade())}});
    }
    return json;
}

}  // namespace

int validate_command(const ValidateRequest& request) {
    std::vector<CaseVerdict> verdicts;
    bool readable = true;
    nlohmann::ordered_json report = nlohmann::ordered_json::array();
    for (const auto& path : request.paths) {
        const auto files = reference_files(path);
        if (files.empty()) {
            std::fprintf(stderr, "%s: no reference case (*.json) here\n", path.c_str());
            readable = false;
        }
        for (const auto& file : files) {
            const ReferenceRead read = read_reference(file);
            print_findings(read.findings);
            readable = readable && !has_errors(read.findings);
            for (const ReferenceCase& reference : read.cases) {
                verdicts.push_back(run_case(reference, request));
                std::fputs(line_of(verdicts.back()).c_str(), stdout);
                std::fflush(stdout);
                if (request.json) report.push_back(to_json(verdicts.back()));
            }
        }
    }
    std::fputs(categories_text(verdicts).c_str(), stdout);
    std::fputs(error_bars_text(verdicts).c_str(), stdout);
    if (request.json) write_text(*request.json, report.dump(1) + '\n');
    if (!readable) return exit_bad_input;
    for (const CaseVerdict& verdict : verdicts)
        if (verdict.grade() != Grade::top && verdict.grade() != Grade::pass) return exit_answer_is_no;
    return exit_done;
}

}  // namespace hanei
