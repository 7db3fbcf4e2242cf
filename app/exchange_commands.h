/// Scenes to and from other programs' files. Each returns an ExitCode.
#pragma once

#include "app/commands.h"

namespace hanei {

struct ImportRequest {
    std::filesystem::path file, out;
    std::optional<std::filesystem::path> into;  ///< a project that the file's objects join; none: a new one
    std::string unit = "m";                     ///< of the file: m, cm, mm, in, ft, or a number of metres
    std::string up = "y";
    std::string as = "auto";  ///< furniture, room, auto
    std::vector<double> at;   ///< m, x and y its footprint is centred at, on the floor; empty: as in the file
};
int import_command(const ImportRequest& request);

struct ExportRequest {
    std::filesystem::path project, out;
    std::string colours = "photo";    ///< false-colour, none: only what was authored
    std::optional<double> low, high;  ///< lx, of false colours
    SettingsChange change;
};
int export_command(const ExportRequest& request);

}  // namespace hanei
