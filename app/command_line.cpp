#include "app/command_line.h"

#include "app/commands.h"
#include "app/desktop.h"
#include "app/exchange_commands.h"
#include "app/exit_code.h"
#include "app/files.h"
#include "app/hard_cases.h"
#include "app/light_commands.h"
#include "app/new_command.h"
#include "app/photometry_command.h"
#include "app/reading_arguments.h"
#include "engine/study/presets.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <map>
#include <memory>

namespace hanei {

namespace {

/// Applies what was given of the common options to a project's settings, in order.
class CommonOptions {
public:
    void add_to(CLI::App& command) {
        std::vector<std::string> names;
        for (const Method method : methods) names.emplace_back(name_of(method));
        command.add_option("--method", method_, "Method of interreflection")->check(CLI::IsMember(names));
        std::apply([&](const auto&... option) { (add(command, option), ...); }, options);
        add_choice(command, "always", EffectChoice::always, "Simulate this effect however little it may add: ");
        add_choice(command, "never", EffectChoice::never, "Skip this effect however much it may add: ");
    }

    SettingsChange change() const {
        return [this](Settings& settings) {
            if (const auto method = method_named(method_)) settings.method = *method;
            for (const auto& [name, apply] : given_) apply(settings);
        };
    }

private:
    template <class T>
    void add(CLI::App& command, const Option<T>& option) {
        const std::string name(option.name);
        std::string help(option.help);
        if (!option.unit.empty()) help += " (" + std::string(option.unit) + ")";
        command
            .add_option_function<T>(
                "--" + name,
                [this, name, option](const T& shown) {
                    given_[name] = [option, shown](Settings& settings) {
                        settings.*option.member = static_cast<T>(shown / static_cast<T>(option.scale));
                    };
                },
                help)
            ->check(CLI::Range(option.low, option.high));
    }

    void add_choice(CLI::App& command, const std::string& name, EffectChoice choice, std::string help) {
        std::vector<std::string> names;
        for (const EffectOption& option : effect_options) {
            help.append(names.empty() ? "" : ", ").append(option.name);
            names.emplace_back(option.name);
        }
        command
            .add_option_function<std::vector<std::string>>(
                "--" + name,
                [this, choice](const std::vector<std::string>& chosen) {
                    for (const std::string& effect : chosen)
                        given_["effect " + effect] = [choice, effect](Settings& settings) {
                            for (const EffectOption& option : effect_options)
                                if (option.name == effect) settings.*option.member = choice;
                        };
                },
                help)
            ->check(CLI::IsMember(names));
    }

    std::string method_;
    std::map<std::string, std::function<void(Settings&)>> given_;
};

/// The arguments of all commands; each lives as long as the parser that writes into it.
struct Arguments {
    DesktopRequest desktop;
    SolveRequest solve;
    RenderRequest render;
    PlanRequest plan;
    NewRequest made;
    SweepRequest study;
    ValidateRequest validate;
    ImportRequest import;
    ExportRequest exported;
    ReadingArguments reading;
    LayoutRequest layout;
    std::filesystem::path check_project, photometry_file, described;
    bool check_hard = false;
    std::optional<std::filesystem::path> photometry_json;
    std::optional<int> photometry_lamp_set;
    std::string size = "1280x800";
    std::string render_size = "1280x800";
    CommonOptions common;
};

/// "1280x800", both 16 to 16384.
std::string check_size(const std::string& text) {
    int width = 0, height = 0, used = 0;
    if (std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &used) == 2 && used == static_cast<int>(text.size()) &&
        std::min(width, height) >= 16 && std::max(width, height) <= 16384)
        return {};
    return "\"" + text + "\" is no size; write WIDTHxHEIGHT in pixels, 16 to 16384 each";
}

void read_size(const std::string& text, int& width, int& height) {
    std::sscanf(text.c_str(), "%dx%d", &width, &height);
}

void add_project(CLI::App& command, std::filesystem::path& into) {
    command.add_option("PROJECT", into, "Project file (.hanei)")->required();
}

void add_desktop(CLI::App& app, Arguments& arguments) {
    app.add_option("PROJECT", arguments.desktop.project, "Project file to open; none: the start room");
    app.add_option("--size", arguments.size, "Size of the window in pixels")->check(CLI::Validator(check_size, "WxH"));
    app.add_option("--scale", arguments.desktop.scale, "Size of letters and controls, 1 to 3; none: as the screen says")
        ->check(CLI::Range(1.0, 3.0));
    app.add_option("--script", arguments.desktop.script,
                   "Play this script of clicks, keys, drags and pictures without a window, then end");
    app.add_option("--state-file", arguments.desktop.state_file,
                   "Keep the window's state here as JSON, for test drivers");
    app.add_option("--user-folder", arguments.desktop.user_folder,
                   "Keep preferences and unsaved work here; else in XDG_CONFIG_HOME and XDG_STATE_HOME, and of scripts "
                   "nothing");
}

void add_solve(CLI::App& app, Arguments& arguments) {
    CLI::App* command = app.add_subcommand("solve", "Compute every calculation grid and point");
    add_project(*command, arguments.solve.project);
    command->add_option("--csv", arguments.solve.csv, "Write every value with its error bar here");
    command->add_option("--json", arguments.solve.json, "The same as JSON, with plan and flux");
    add_light_scene(*command, arguments.solve.light_scene);
    auto* const compare = command->add_option(
        "--compare", arguments.solve.compared_with,
        "Values of a meter or another program (CSV) to compare with: columns lux, and set and index, or x, y, z");
    command->add_option("--differences", arguments.solve.differences, "Write every compared pair here (CSV)")
        ->needs(compare);
    auto* preset = command
                       ->add_option("--preset", arguments.solve.preset,
                                    "Choose method, patch width and accuracy: draft (95 of 100 points within 10 %), "
                                    "design (3 %), verify (1 %), as studies on this machine predict it")
                       ->check(CLI::IsMember({"draft", "design", "verify"}));
    command->add_option("--within", arguments.solve.within, "The same for any wish (percent)")
        ->check(CLI::Range(100.0 * least_wish, 100.0 * greatest_wish))
        ->excludes(preset);
    arguments.common.add_to(*command);
}

void add_render(CLI::App& app, Arguments& arguments) {
    CLI::App* command = app.add_subcommand("render", "Draw a picture (PNG) without a display");
    RenderRequest& request = arguments.render;
    add_project(*command, request.project);
    command->add_option("--out", request.out, "PNG file to write; with --name-template the folder")->required();
    command->add_option("--name-template", request.name_template,
                        "Name of the file: {project} {view} {part} {date} {time} {size} are replaced");
    command->add_option("--view", request.view,
                        "A saved view by name or number, or overview, plan, ceiling-plan, front, back, left, right");
    command->add_flag("--no-ceiling", request.no_ceiling, "Take the ceiling off, as of a doll's house");
    command->add_option("--cut", request.cut,
                        "Section plane: x=2 leaves out what lies beyond x = 2 m, -x=2 what lies before it; y, z alike");
    command->add_option("--size", arguments.render_size, "Size of the picture in pixels")
        ->check(CLI::Validator(check_size, "WxH"));
    command
        ->add_option("--part", request.part,
                     "Which light; four-up: all four side by side; shadow-classes: patches by how light reaches them")
        ->check(CLI::IsMember({"total", "direct", "interreflected", "unshadowed", "four-up", "shadow-classes"}));
    command->add_flag("--shadow-outlines", request.shadow_outlines,
                      "Draw the borders of umbra (solid) and penumbra (dashed) over the picture");
    command->add_option("--luminaire", request.luminaire,
                        "Whose shadow classes and outlines, by name or number; none: all luminaires");
    command->add_option("--scale", request.scale, "How it is coloured")
        ->check(CLI::IsMember({"false-colour", "photo"}));
    command
        ->add_option("--steps", request.steps,
                     "Colour scale: logarithmic, linear, or steps of EN 12464-1; else the project's")
        ->check(CLI::IsMember({"log", "linear", "en"}));
    command->add_option("--low", request.low, "Lower end of the colour scale (lx); else the project's or fitted")
        ->check(CLI::PositiveNumber);
    command->add_option("--high", request.high, "Upper end of the colour scale (lx)")->check(CLI::PositiveNumber);
    command->add_flag("--fit", request.fits, "Fit the colour scale to the light, whatever the project's scale is");
    command->add_flag("--mark-clipped", request.marks_clipped, "Hatch what lies outside the colour scale");
    command->add_option("--isolux", request.isolux, "Levels of the isolux lines, such as 100,300,500")
        ->delimiter(',')
        ->check(CLI::PositiveNumber);
    command->add_option("--unit", request.unit, "Unit of figures in the picture: lux or foot-candles")
        ->check(CLI::IsMember({"lx", "fc"}));
    command->add_flag("--values", request.values, "Write the figures of calculation grids and points into the picture");
    command->add_flag("--plain", request.plain, "No legend, no caption and no scale bar");
    command->add_flag("--no-scale-bar", request.no_scale_bar, "No scale bar in pictures to scale (plan, front, ...)");
    command->add_flag("--axes", request.axes, "Show in a corner which way x, y and z run");
    command->add_option("--length-unit", request.length_unit, "Unit of the scale bar")
        ->check(CLI::IsMember({"m", "cm", "mm", "ft"}));
    add_light_scene(*command, request.light_scene);
    command->add_flag("--exact", request.exact,
                      "Direct light exact at every pixel and smooth edges of objects and shadows: takes seconds");
    command
        ->add_option("--samples", request.samples,
                     "Rays a pixel where neighbours differ, with --exact; 1: one everywhere")
        ->check(CLI::Range(1, 256));
    arguments.common.add_to(*command);
}

void add_describe(CLI::App& app, Arguments& arguments) {
    CLI::App* command = app.add_subcommand("describe", "What an exported picture says of itself");
    command->add_option("PICTURE", arguments.described, "PNG file")->required();
}

void add_plan(CLI::App& app, Arguments& arguments) {
    CLI::App* command = app.add_subcommand("plan", "Show which effects the scene calls for, and why");
    add_project(*command, arguments.plan.project);
    command->add_option("--json", arguments.plan.json, "Write the plan here");
    command->add_flag("--measure", arguments.plan.measure,
                      "Solve with and without each effect: what it really adds and takes here");
    arguments.common.add_to(*command);
}

void add_study(CLI::App& app, Arguments& arguments) {
    CLI::App* command = app.add_subcommand("study", "Accuracy against time: methods and patch widths on this scene");
    command
        ->add_option(
            "PROJECT", arguments.study.project,
            "Project file (.hanei): errors against the finest run, with its own uncertainty. Or a reference case "
            "(.json): errors against its expected values, for each set of its points")
        ->required();
    command->add_option("--out", arguments.study.out, "Folder for accuracy-time.csv and .svg")->required();
    command
        ->add_option("--budget", arguments.study.budget,
                     "Time for all runs (s); those that are predicted to go beyond it are left out, and told")
        ->check(CLI::Range(0.5, 86'400.0))
        ->capture_default_str();
    arguments.common.add_to(*command);
    command->footer(
        "Every method runs with patches of 4, 2, 1 and 1/2 times --max-patch, linear of twice these, each with 1, 2, "
        "4, "
        "10 and all interreflections (paper with ten at most), with and without shadows between surfaces; then the "
        "present settings, the paper's own, the presets draft, design and verify, and the lumen method. What no other "
        "beats is the frontier. Times are kept in XDG_STATE_HOME/hanei/calibration.json: from them the presets are "
        "predicted. Ctrl+C ends it and keeps what was found.");
}

void add_new(CLI::App& app, Arguments& arguments) {
    CLI::App* command = app.add_subcommand("new", "Make a project with a furnished room");
    NewRequest& request = arguments.made;
    command->add_option("OUT", request.out, "Project file to write (.hanei)");
    command->add_option("--room", request.room, "Length x width x height (m), as 6x4x2.8");
    command->add_option("--shape", request.shape, "Its plan")->check(CLI::IsMember({"box", "L", "T", "U"}));
    command->add_option("--plan", request.plan, "Corners of another plan (m), as \"0,0 6,0 6,4 0,4\"");
    command->add_option("--reflectances", request.reflectances, "Ceiling, walls and floor in percent, as 70/50/20");
    command->add_option("--furniture", request.furniture,
                        "Pieces of the library, as desk, desk@1.5,2,90 (x, y, degrees), desk:width=1.8@1.5,2");
    command->add_option("--opening", request.openings,
                        "Doors, windows, boards, as door:1 (on wall 1), window:2@1.5 (its middle 1.5 m along)");
    command->add_flag("--list", request.lists, "Name all furniture with its sizes, and all openings");
}

void add_check(CLI::App& app, Arguments& arguments) {
    CLI::App* command = app.add_subcommand("check", "Find faults of the file and of the scene");
    command->add_option("PROJECT", arguments.check_project, "Project file (.hanei)");
    command->add_flag("--hard", arguments.check_hard,
                      "Compute the gallery of hard cases: what is right, what is naive, what comes out");
    command->require_option(1);
}

void add_validate(CLI::App& app, Arguments& arguments) {
    CLI::App* command = app.add_subcommand("validate", "Compute reference cases and compare with what is expected");
    auto* const paths = command->add_option("PATH", arguments.validate.paths,
                                            "Case files, or folders that are searched downwards; none: the cases that "
                                            "come with the program, as a table that is signed");
    command->add_option("--csv", arguments.validate.csv, "Write that table here")->excludes(paths);
    command->add_option("--json", arguments.validate.json, "Write every point here");
    arguments.common.add_to(*command);
}

void add_photometry(CLI::App& app, Arguments& arguments) {
    CLI::App* command = app.add_subcommand("photometry", "What a luminaire file says and what follows from it");
    command->add_option("FILE", arguments.photometry_file, "Luminaire file (.ies, .ldt, .xml, .gldf)")->required();
    command->add_option("--lamp-set", arguments.photometry_lamp_set, "Use this lamp set, counted from 1")
        ->check(CLI::PositiveNumber);
    command->add_option("--json", arguments.photometry_json, "Write the same as JSON");
}

void add_import(CLI::App& app, Arguments& arguments) {
    CLI::App* command = app.add_subcommand("import", "Take furniture or a room from a glTF file (.gltf, .glb)");
    ImportRequest& request = arguments.import;
    command->add_option("FILE", request.file, "File to read")->required();
    command->add_option("--out", request.out, "Project file to write")->required();
    command->add_option("--into", request.into, "Project whose scene the file's objects join; none: a new one");
    command->add_option("--unit", request.unit, "Unit of the file: m, cm, mm, in, ft, or a number of metres");
    command->add_option("--up", request.up, "Axis of the file that points up")->check(CLI::IsMember({"y", "z"}));
    command->add_option("--as", request.as, "What it holds; auto: what looks like a room is one")
        ->check(CLI::IsMember({"furniture", "room", "auto"}));
    command->add_option("--at", request.at, "Stand it on the floor, its footprint centred here: X Y (m)")->expected(2);
}

void add_export(CLI::App& app, Arguments& arguments) {
    CLI::App* command = app.add_subcommand("export", "Write the scene, and its light as vertex colours, as glTF");
    ExportRequest& request = arguments.exported;
    add_project(*command, request.project);
    command->add_option("--out", request.out, "File to write: .glb, or .gltf as text")->required();
    command->add_option("--colours", request.colours, "What the light looks like; none: only what was authored")
        ->check(CLI::IsMember({"photo", "false-colour", "none"}));
    command->add_option("--low", request.low, "Lower end of false colours (lx)")->check(CLI::PositiveNumber);
    command->add_option("--high", request.high, "Upper end of false colours (lx)")->check(CLI::PositiveNumber);
    arguments.common.add_to(*command);
}

int run_desktop_from(Arguments& arguments) {
    read_size(arguments.size, arguments.desktop.width, arguments.desktop.height);
    return run_desktop(arguments.desktop);
}

int run(const CLI::App& app, Arguments& arguments) {
    const auto change = arguments.common.change();
    if (app.got_subcommand("solve")) {
        arguments.solve.change = change;
        return solve_command(arguments.solve);
    }
    if (app.got_subcommand("render")) {
        arguments.render.change = change;
        read_size(arguments.render_size, arguments.render.width, arguments.render.height);
        return render_command(arguments.render);
    }
    if (app.got_subcommand("describe")) return describe_command(arguments.described);
    if (const auto done = run_reading(app, arguments.reading, change)) return *done;
    if (app.got_subcommand("plan")) {
        arguments.plan.change = change;
        return plan_command(arguments.plan);
    }
    if (app.got_subcommand("study")) {
        arguments.study.change = change;
        return study_command(arguments.study);
    }
    if (app.got_subcommand("import")) return import_command(arguments.import);
    if (app.got_subcommand("export")) {
        arguments.exported.change = change;
        return export_command(arguments.exported);
    }
    if (app.got_subcommand("layout")) {
        arguments.layout.change = change;
        return layout_command(arguments.layout);
    }
    if (app.got_subcommand("new")) return new_command(arguments.made);
    if (app.got_subcommand("check") && arguments.check_hard) return check_hard_command();
    if (app.got_subcommand("check")) return check_command(arguments.check_project);
    if (app.got_subcommand("validate")) {
        arguments.validate.change = change;
        return validate_command(arguments.validate);
    }
    if (app.got_subcommand("photometry"))
        return photometry_command(arguments.photometry_file, arguments.photometry_lamp_set, arguments.photometry_json,
                                  std::cout, std::cerr);
    return run_desktop_from(arguments);
}

}  // namespace

int run_command_line(int argc, char** argv) {
    CLI::App app{"Hanei: lighting design with exact direct light and interreflection, and an error bar on every value",
                 "hanei"};
    app.set_version_flag("--version", "Hanei " HANEI_VERSION);
    app.require_subcommand(0, 1);
    app.footer("Exit codes: 0 done; 1 the answer is no; 2 bad input or usage; 3 the machine failed.");
    Arguments arguments;
    add_desktop(app, arguments);
    add_solve(app, arguments);
    add_render(app, arguments);
    add_describe(app, arguments);
    add_reading(app, arguments.reading, [&](CLI::App& command) { arguments.common.add_to(command); });
    add_new(app, arguments);
    add_plan(app, arguments);
    add_study(app, arguments);
    arguments.common.add_to(add_layout(app, arguments.layout));
    add_check(app, arguments);
    add_validate(app, arguments);
    add_photometry(app, arguments);
    add_import(app, arguments);
    add_export(app, arguments);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& fault) {
        return app.exit(fault) == 0 ? exit_done : exit_bad_input;
    }
    return run(app, arguments);
}

}  // namespace hanei
