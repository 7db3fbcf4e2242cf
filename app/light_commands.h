/// Luminaires counted and dimmers set from the command line.
#pragma once

#include "app/commands.h"

namespace CLI {
class App;
}

namespace hanei {

struct LayoutRequest {
    std::filesystem::path project, luminaire, out;
    double target = 500.0;        ///< lx
    double working_plane = 0.75;  ///< m above the floor
    double border = 0.5;          ///< m
    std::string mounting = "recessed";
    double suspension = 0.5;  ///< m
    std::string grid;         ///< "3x4" columns and rows; empty: chosen
    bool solve = false;       ///< and compare with the solution
    SettingsChange change;
};
/// Hangs a field of luminaires for an illuminance by the lumen method and writes the project.
int layout_command(const LayoutRequest& request);

/// The scene with the light scene of this name recalled; as it is for an empty name.
/// Returns   false after a sentence on stderr when there is none of it.
bool recall_light_scene(Scene& scene, const std::string& name, const std::filesystem::path& project);

/// Their arguments: the command "layout", and the option "--light-scene" of others.
CLI::App& add_layout(CLI::App& app, LayoutRequest& request);
void add_light_scene(CLI::App& command, std::string& into);

}  // namespace hanei
