#include "app/built_in_cases.h"
#include "app/commands.h"
#include "app/exit_code.h"
#include "app/files.h"
#include "app/reference_run.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace hanei {

namespace {

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

bool good(const CaseVerdict& verdict) { return verdict.grade() == Grade::top || verdict.grade() == Grade::pass; }

int validate_paths(const ValidateRequest& request) {
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
                verdicts.push_back(*run_reference(reference, request.change, Work{}));
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
    return std::all_of(verdicts.begin(), verdicts.end(), good) ? exit_done : exit_answer_is_no;
}

int validate_built_in(const ValidateRequest& request) {
    const BuiltInCases cases = built_in_cases();
    print_findings(cases.findings);
    if (cases.cases.empty() || has_errors(cases.findings)) return exit_bad_input;
    nlohmann::ordered_json report = nlohmann::ordered_json::array();
    std::fputs(validation_heading().c_str(), stdout);
    const auto validation =
        validate(cases, request.change, Work{}, [&](const CaseVerdict& verdict, const ValidationRow& row) {
            std::fputs(line_of(row).c_str(), stdout);
            std::fflush(stdout);
            if (request.json) report.push_back(to_json(verdict));
        });
    std::fputs(validation_notes(*validation).c_str(), stdout);
    if (request.json) write_text(*request.json, report.dump(1) + '\n');
    if (request.csv) write_text(*request.csv, validation_csv(*validation));
    return validation->holds() ? exit_done : exit_answer_is_no;
}

}  // namespace

int validate_command(const ValidateRequest& request) {
    return request.paths.empty() ? validate_built_in(request) : validate_paths(request);
}

}  // namespace hanei
