#include "app/reading_arguments.h"

#include <CLI/CLI.hpp>

namespace hanei {
namespace {

void add_why(CLI::App& app, ReadingArguments& arguments, const AddCommon& add_common) {
    CLI::App* command = app.add_subcommand(
        "why", "Why it is as bright at a place as it is: by luminaire, group, reflection and surface");
    WhyRequest& request = arguments.why;
    command->add_option("PROJECT", request.project, "Project file (.hanei)")->required();
    auto* const at = command->add_option("--at", request.at, "The place, as X,Y,Z (m)")->delimiter(',')->expected(3);
    command->add_option("--normal", request.normal, "The direction that the place faces; none: up, 0,0,1")
        ->delimiter(',')
        ->expected(3);
    command->add_option("--point", request.point, "A calculation point by name or number, in place of --at")
        ->excludes(at);
    command->add_option("--json", request.json, "Write the same as JSON");
    add_common(*command);
}

void add_profile(CLI::App& app, ReadingArguments& arguments, const AddCommon& add_common) {
    CLI::App* command = app.add_subcommand("profile", "The light along a straight line, as CSV");
    ProfileRequest& request = arguments.profile;
    command->add_option("PROJECT", request.project, "Project file (.hanei)")->required();
    command->add_option("--from", request.from, "Where it begins, as X,Y,Z (m)")
        ->delimiter(',')
        ->expected(3)
        ->required();
    command->add_option("--to", request.to, "Where it ends, as X,Y,Z (m)")->delimiter(',')->expected(3)->required();
    command->add_option("--normal", request.normal, "The direction that its places face; none: up, 0,0,1")
        ->delimiter(',')
        ->expected(3);
    command->add_option("--csv", request.csv, "Write it here instead of to standard output");
    add_common(*command);
}

void add_compare(CLI::App& app, ReadingArguments& arguments, const AddCommon& add_common) {
    CLI::App* command = app.add_subcommand("compare", "Compare the light of two projects: what B has more than A");
    CompareRequest& request = arguments.compare;
    command->add_option("A", request.first, "Project file (.hanei)")->required();
    command->add_option("B", request.second, "Project file (.hanei)")->required();
    command->add_option("--out", request.out, "Draw B minus A here (PNG)");
    command->add_option("--view", request.view, "A view of B by name or number, \"overview\" or \"plan\"");
    command->add_option("--width", request.width, "Width of the picture in pixels")->check(CLI::Range(16, 16384));
    command->add_option("--height", request.height, "Height of the picture in pixels")->check(CLI::Range(16, 16384));
    command->add_option("--range", request.range, "The greatest difference that colours tell (lx); none: fitted")
        ->check(CLI::PositiveNumber);
    add_common(*command);
}

void add_trust(CLI::App& app, ReadingArguments& arguments, const AddCommon& add_common) {
    CLI::App* command = app.add_subcommand(
        "trust", "Check an answer by what must hold of any: energy, reciprocity, closure, additivity, threads");
    command->add_option("PROJECT", arguments.trust.project, "Project file (.hanei)")->required();
    command->add_option("--json", arguments.trust.json, "Write the same as JSON");
    add_common(*command);
}

}  // namespace

void add_reading(CLI::App& app, ReadingArguments& arguments, const AddCommon& add_common) {
    add_why(app, arguments, add_common);
    add_profile(app, arguments, add_common);
    add_compare(app, arguments, add_common);
    add_trust(app, arguments, add_common);
}

std::optional<int> run_reading(const CLI::App& app, ReadingArguments& arguments, const SettingsChange& change) {
    arguments.why.change = arguments.profile.change = arguments.compare.change = arguments.trust.change = change;
    if (app.got_subcommand("why")) return why_command(arguments.why);
    if (app.got_subcommand("profile")) return profile_command(arguments.profile);
    if (app.got_subcommand("compare")) return compare_command(arguments.compare);
    if (app.got_subcommand("trust")) return trust_command(arguments.trust);
    return std::nullopt;
}

}  // namespace hanei
