#include "app/trust_command.h"

#include "app/exit_code.h"
#include "app/files.h"
#include "engine/report/trust_report.h"

#include <cstdio>

namespace hanei {

int trust_command(const TrustRequest& request) {
    auto project = open_project(request.project);
    if (!project) return exit_bad_input;
    request.change(project->settings);
    const auto scene = std::make_shared<const Scene>(std::move(project->scene));
    const auto report = trust_in(scene, project->settings, Work{});
    std::fputs(trust_text(*report).c_str(), stdout);
    if (request.json) write_text(*request.json, trust_json(*report));
    return report->holds() ? exit_done : exit_answer_is_no;
}

}  // namespace hanei
