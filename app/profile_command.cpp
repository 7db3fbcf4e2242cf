#include "app/profile_command.h"

#include "app/exit_code.h"
#include "app/files.h"
#include "engine/report/profile_report.h"
#include "engine/study/study.h"

#include <cstdio>

namespace hanei {

int profile_command(const ProfileRequest& request) {
    const auto place = [](const std::vector<double>& figures) { return Vec3(figures[0], figures[1], figures[2]); };
    const ProfileLine line{place(request.from), place(request.to), place(request.normal)};
    if (!(line.length() > 0.0)) {
        std::fputs("--from, --to: both are the same place; a profile needs a line of some length\n", stderr);
        return exit_bad_input;
    }
    if (!(glm::length(line.normal) > 0.0)) {
        std::fputs("--normal: 0,0,0 has no direction; write the direction that the places face, such as 0,0,1\n",
                   stderr);
        return exit_bad_input;
    }
    auto project = open_project(request.project);
    if (!project) return exit_bad_input;
    request.change(project->settings);
    const auto scene = std::make_shared<const Scene>(std::move(project->scene));
    ProfileSampler profile(Study().run(scene, project->settings, {}, Work{}), line);
    while (!profile.done()) profile.advance(100);
    const std::string csv = profile_csv(profile);
    if (request.csv)
        write_text(*request.csv, csv);
    else
        std::fputs(csv.c_str(), stdout);
    return exit_done;
}

}  // namespace hanei
