/// `hanei profile`: the light along a line. `hanei compare`: two projects, grid by grid and as a picture.
#pragma once

#include "app/commands.h"

namespace hanei {

struct ProfileRequest {
    std::filesystem::path project;
    std::vector<double> from, to;                  ///< m: x, y, z
    std::vector<double> normal = {0.0, 0.0, 1.0};  ///< of the places along the line
    std::optional<std::filesystem::path> csv;      ///< none: standard output
    SettingsChange change;
};
int profile_command(const ProfileRequest& request);

struct CompareRequest {
    std::filesystem::path first, second;
    std::optional<std::filesystem::path> out;  ///< PNG: second minus first
    std::string view;                          ///< of the second, as for render
    int width = 1280, height = 800;
    std::optional<double> range;  ///< lx, of the greatest difference that colours tell
    SettingsChange change;
};
int compare_command(const CompareRequest& request);

}  // namespace hanei
