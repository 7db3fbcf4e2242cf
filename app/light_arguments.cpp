#include "app/light_commands.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

namespace hanei {

namespace {

/// "3x4", both 1 to 200.
std::string check_grid(const std::string& text) {
    int columns = 0, rows = 0, used = 0;
    if (std::sscanf(text.c_str(), "%dx%d%n", &columns, &rows, &used) == 2 && used == static_cast<int>(text.size()) &&
        std::min(columns, rows) >= 1 && std::max(columns, rows) <= 200)
        return {};
    return "\"" + text + "\" is no grid; write COLUMNSxROWS, 1 to 200 each";
}

}  // namespace

void add_light_scene(CLI::App& command, std::string& into) {
    command.add_option("--light-scene", into, "Recall this light scene first, by name");
}

CLI::App& add_layout(CLI::App& app, LayoutRequest& request) {
    CLI::App* command =
        app.add_subcommand("layout", "Hang a field of luminaires for an illuminance, by the lumen method");
    command->add_option("PROJECT", request.project, "Project file (.hanei)")->required();
    command->add_option("--luminaire", request.luminaire, "Luminaire file (.ies, .ldt, .xml, .gldf)")->required();
    command->add_option("--out", request.out, "Project file to write")->required();
    command->add_option("--target", request.target, "Mean illuminance on the working plane (lx)")
        ->check(CLI::PositiveNumber);
    command->add_option("--working-plane", request.working_plane, "Its height above the floor (m)")
        ->check(CLI::Range(0.0, 100.0));
    command->add_option("--border", request.border, "What it leaves out along the walls (m)")
        ->check(CLI::Range(0.0, 100.0));
    command->add_option("--mounting", request.mounting, "How they hang")
        ->check(CLI::IsMember({"recessed", "surface", "pendant"}));
    command->add_option("--suspension", request.suspension, "Of pendants, from the ceiling (m)")
        ->check(CLI::Range(0.0, 100.0));
    command->add_option("--grid", request.grid, "COLUMNSxROWS instead of as many as the target needs")
        ->check(CLI::Validator(check_grid, "CxR"));
    command->add_flag("--solve", request.solve, "Compute the room too, and compare");
    return *command;
}

}  // namespace hanei
