#include "app/hard_cases.h"

#include "app/exit_code.h"
#include "app/files.h"
#include "engine/project/project_file.h"
#include "engine/scene/hard_spots.h"
#include "engine/study/study.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>

namespace hanei {
namespace {

SolutionSnapshot solved(const Project& project) {
    return Study().run(std::make_shared<const Scene>(project.scene), project.settings, StudyRequest{.energy = true},
                       Work{.threads = project.settings.threads});
}

/// The place of the point in the lists of scene and solution.
std::optional<std::size_t> place_of(const Scene& scene, const std::string& point) {
    const auto found = std::find_if(scene.points.begin(), scene.points.end(),
                                    [&](const CalculationPoint& candidate) { return candidate.name == point; });
    if (found == scene.points.end()) return std::nullopt;
    return static_cast<std::size_t>(found - scene.points.begin());
}

/// All light of every opening from its middle: the inverse square law, and one ray that asks for a shadow.
Scene with_light_from_the_middle(Scene scene) {
    for (Luminaire& luminaire : scene.luminaires) {
        if (!std::holds_alternative<PolygonOpening>(luminaire.opening)) continue;
        luminaire.opening = PointOpening{};
        luminaire.distribution = CosinePower{1.0};
    }
    return scene;
}

SolutionSnapshot naive_solution(Project project, const std::string& by) {
    if (by == "centre") project.scene = with_light_from_the_middle(std::move(project.scene));
    if (by == "paper") {
        project.settings.method = Method::paper;
        project.settings.bounces = 4;
    }
    return by.empty() ? nullptr : solved(project);
}

double lux_of(const PointValue& value, bool direct_only) {
    return direct_only ? value.direct.value : value.total().value;
}

void judge_figures(const HardCase& wanted, const Project& project, const Solution& solution,
                   const SolutionSnapshot& naive, HardOutcome& outcome) {
    for (const HardFigure& figure : wanted.figures) {
        const auto place = place_of(project.scene, figure.point);
        if (!place) {
            outcome.faults.push_back("there is no point \"" + figure.point + "\"");
            continue;
        }
        const PointValue& value = solution.points[*place].value;
        HardOutcome::Figure got{figure, lux_of(value, figure.direct_only), value.error.total(), figure.naive};
        if (figure.direct_only) got.error_bar = value.error.sampling;
        if (naive) got.naive = lux_of(naive->points[*place].value, figure.direct_only);
        if (!(std::abs(got.got - figure.expected) <= figure.tolerance))
            outcome.faults.push_back(fmt::format("{}: {:.9g} lx, expected are {:.9g} +- {:.2g} lx", figure.point,
                                                 got.got, figure.expected, figure.tolerance));
        outcome.figures.push_back(std::move(got));
    }
}

/// Direct light to rounding of coordinates, all light within the error bars of both.
void judge_likeness(const std::filesystem::path& other, const Solution& solution, const SolutionSnapshot& naive,
                    HardOutcome& outcome) {
    constexpr double of_direct = 1e-9;
    const ProjectRead read = read_project(other);
    if (!read.project) return outcome.faults.push_back("cannot read " + other.string());
    const SolutionSnapshot model = solved(*read.project);
    if (model->points.size() != solution.points.size()) return outcome.faults.push_back("it has other points");
    for (std::size_t k = 0; k < model->points.size(); ++k) {
        const PointValue &is = solution.points[k].value, &was = model->points[k].value;
        const std::string name = read.project->scene.points[k].name;
        HardFigure wanted{name, false, was.total().value, is.error.total() + was.error.total()};
        if (!(std::abs(is.direct.value - was.direct.value) <= of_direct * was.direct.value))
            outcome.faults.push_back(fmt::format("{}: {:.12g} lx direct, in {} {:.12g} lx", name, is.direct.value,
                                                 other.filename().string(), was.direct.value));
        if (!(std::abs(is.total().value - wanted.expected) <= wanted.tolerance))
            outcome.faults.push_back(fmt::format("{}: {:.9g} lx, in {} {:.9g} lx", name, is.total().value,
                                                 other.filename().string(), wanted.expected));
        outcome.figures.push_back({std::move(wanted), is.total().value, is.error.total(), std::nullopt});
        if (naive) outcome.figures.back().naive = naive->points[k].value.total().value;
    }
}

void judge_solution(const std::filesystem::path& folder, const HardCase& wanted, const Project& project,
                    HardOutcome& outcome) {
    const SolutionSnapshot solution = solved(project);
    outcome.refusal = solution->refusal;
    if (wanted.refusal.empty() != solution->refusal.empty() ||
        solution->refusal.find(wanted.refusal) == std::string::npos)
        outcome.faults.push_back("the refusal is \"" + solution->refusal + '"');
    const SolutionSnapshot naive = naive_solution(project, wanted.naive_by);
    judge_figures(wanted, project, *solution, naive, outcome);
    if (!wanted.same_as.empty()) judge_likeness(folder / wanted.same_as, *solution, naive, outcome);
    if (wanted.escaped_lm && !(std::abs(solution->energy.escaped - *wanted.escaped_lm) <= wanted.escaped_tolerance))
        outcome.faults.push_back(fmt::format("{:.6g} lm escaped, expected are {:.6g} +- {:.2g} lm",
                                             solution->energy.escaped, *wanted.escaped_lm, wanted.escaped_tolerance));
}

}  // namespace

HardOutcome solve_hard_case(const std::filesystem::path& folder, const HardCase& wanted) {
    HardOutcome outcome;
    const ProjectRead read = read_project(folder / wanted.file);
    Diagnostics findings = read.findings;
    if (read.project) {
        const Diagnostics spots = hard_spots(read.project->scene);
        findings.insert(findings.end(), spots.begin(), spots.end());
    }
    for (const Diagnostic& finding : findings) outcome.findings.push_back(finding.place.field + ": " + finding.message);
    for (const std::string& words : wanted.finds)
        if (std::none_of(findings.begin(), findings.end(),
                         [&](const Diagnostic& finding) { return finding.message.find(words) != std::string::npos; }))
            outcome.faults.push_back("no finding says \"" + words + '"');
    if (read.project)
        judge_solution(folder, wanted, *read.project, outcome);
    else if (!wanted.figures.empty() || wanted.finds.empty())
        outcome.faults.push_back("the file was not read");
    return outcome;
}

std::string text_of(const HardCase& wanted, const HardOutcome& outcome) {
    std::string text = fmt::format("{}  ({})\n  hard   {}\n  right  {}\n  naive  {}\n", wanted.title, wanted.file,
                                   wanted.why, wanted.right, wanted.naive);
    for (const HardOutcome::Figure& figure : outcome.figures) {
        text += fmt::format("  {:<40} {:>12.6g} +- {:.2g} lx{}, right {:.6g}", figure.wanted.point, figure.got,
                            figure.error_bar, figure.wanted.direct_only ? " direct" : "", figure.wanted.expected);
        text += figure.naive ? fmt::format(", naive {:.6g}\n", *figure.naive) : "\n";
    }
    for (const std::string& finding : outcome.findings) text += "  found  " + finding + '\n';
    if (!outcome.refusal.empty()) text += "  refused  " + outcome.refusal + '\n';
    for (const std::string& fault : outcome.faults) text += "  WRONG  " + fault + '\n';
    return text;
}

std::string row_of(const HardCase& wanted, const HardOutcome& outcome) {
    double off = 0.0, bar = 0.0;
    std::optional<double> naive;
    for (const HardOutcome::Figure& figure : outcome.figures) {
        off = std::max(off, std::abs(figure.got - figure.wanted.expected));
        bar = std::max(bar, figure.error_bar);
        if (figure.naive) naive = std::max(naive.value_or(0.0), std::abs(*figure.naive - figure.wanted.expected));
    }
    std::string covers;
    for (const std::string& kind : wanted.covers) covers += (covers.empty() ? "" : ", ") + kind;
    const auto lux = [](double value) { return value == 0.0 ? std::string("0") : fmt::format("{:.1e}", value); };
    const bool figures = !outcome.figures.empty();
    const std::string how = !outcome.refusal.empty() ? "refused" : figures ? "right" : "told";
    return fmt::format("{:<8} {:<36} {:>9} {:>9} {:>9}  {}\n", outcome.faults.empty() ? how : "WRONG", wanted.file,
                       figures ? lux(off) : "-", figures ? lux(bar) : "-", naive ? lux(*naive) : "-", covers);
}

int check_hard_command() {
    Diagnostics findings;
    const std::vector<HardCase> cases = read_hard_cases(hard_folder(), findings);
    print_findings(findings);
    std::size_t right = 0;
    std::string table = fmt::format("{:<8} {:<36} {:>9} {:>9} {:>9}  {}\n", "result", "file", "off by", "+- lx",
                                    "naive", "what is hard");
    for (const HardCase& wanted : cases) {
        const HardOutcome outcome = solve_hard_case(hard_folder(), wanted);
        if (outcome.faults.empty()) ++right;
        std::printf("%s\n", text_of(wanted, outcome).c_str());
        std::fflush(stdout);  // some take seconds
        table += row_of(wanted, outcome);
    }
    std::printf("%s\n", table.c_str());
    std::printf("%zu of %zu hard cases as they should be\n", right, cases.size());
    if (cases.empty() || has_errors(findings)) return exit_bad_input;
    return right == cases.size() ? exit_done : exit_answer_is_no;
}

}  // namespace hanei
