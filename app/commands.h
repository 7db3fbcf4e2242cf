/// The commands of the program, after their arguments were read. Each returns an ExitCode.
#pragma once

#include "engine/plan/settings.h"
#include "engine/scene/scene.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace hanei {

/// What the common options change of a project's own settings.
using SettingsChange = std::function<void(Settings&)>;

struct SolveRequest {
    std::filesystem::path project;
    std::optional<std::filesystem::path> csv, json;
    SettingsChange change;
    bool no_ceiling = false;
    std::string cut{};          ///< "z=1.2": what lies above is left out; "-z=1.2": what lies below; empty: as the view
    std::string light_scene{};  ///< recalled first, by name; empty: the dimmers as they are
    std::optional<std::filesystem::path> compared_with{}, differences{};  ///< values of others; where pairs go (CSV)
    std::string preset{};       ///< draft, design, verify: chooses method, patch width and accuracy
    double within = 0.0;        ///< percent, the same for any wish; 0: none
};
int solve_command(const SolveRequest& request);

struct RenderRequest {
    std::filesystem::path project, out;
    std::string name_template;  ///< not empty: `out` is a folder, and this names the file in it
    std::string view;           ///< a saved view by name or number from 1; a Standpoint's word; empty: the first
    int width = 1280, height = 800;
    std::string part = "total";  ///< or "four-up", "shadow-classes"
    bool shadow_outlines = false;
    std::string luminaire;  ///< whose shadows, by name or number from 1; empty: all
    std::string scale = "false-colour";
    bool no_ceiling = false;          ///< looked into from above, as into a doll's house
    std::string cut;                  ///< "z=1.2": only what lies below is drawn; empty: as the view says
    std::string steps;                ///< log, linear, en; empty: as the project's scale
    std::optional<double> low, high;  ///< lx
    bool fits = false;                ///< the scale is fitted to the light, whatever the project's is
    bool marks_clipped = false;       ///< what lies outside the scale is hatched
    bool values = false;              ///< figures at calculation points
    std::vector<double> isolux;       ///< in `unit`; none: as the project's scale
    std::string unit = "lx";          ///< or "fc"
    bool plain = false;               ///< no legend, no caption
    bool exact = false;               ///< direct light exact at every pixel
    int samples = 16;                 ///< rays a pixel at edges, when exact
    SettingsChange change;
    std::string light_scene{};      ///< recalled first, by name; empty: the dimmers as they are
    bool no_scale_bar = false;      ///< of a picture to scale
    bool axes = false;              ///< which way x, y and z run
    std::string length_unit = "m";  ///< of the scale bar; or "cm", "mm", "ft"
};
int render_command(const RenderRequest& request);

struct PlanRequest {
    std::filesystem::path project;
    std::optional<std::filesystem::path> json;
    SettingsChange change;
    bool measure = false;  ///< what each effect really adds and takes
};
int plan_command(const PlanRequest& request);

struct SweepRequest {
    std::filesystem::path project, out;
    SettingsChange change;
    double budget = 60.0;  ///< s
};
int study_command(const SweepRequest& request);

/// Prints what a picture that was exported says of itself.
int describe_command(const std::filesystem::path& picture);

int check_command(const std::filesystem::path& project);

struct ValidateRequest {
    std::vector<std::filesystem::path> paths;  ///< none: the cases that come with the program
    std::optional<std::filesystem::path> json;
    SettingsChange change;
    std::optional<std::filesystem::path> csv{};  ///< the signed-off table; of the cases that come with the program
};
int validate_command(const ValidateRequest& request);

}  // namespace hanei
