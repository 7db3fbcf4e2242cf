#include "app/commands.h"
#include "app/exit_code.h"
#include "app/files.h"
#include "app/interrupt.h"
#include "app/light_commands.h"
#include "app/progress_line.h"
#include "engine/base/tiles.h"
#include "engine/study/study.h"
#include "ui/panels/exact_room.h"
#include "ui/panels/picture_name.h"
#include "ui/view/offscreen.h"
#include "ui/view/picture_text.h"
#include "ui/view/standpoint.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>

namespace hanei {

namespace {

LengthUnit length_unit_named(std::string_view name) {
    return name == "cm"   ? LengthUnit::centimetre
           : name == "mm" ? LengthUnit::millimetre
           : name == "ft" ? LengthUnit::feet_inches
                          : LengthUnit::metre;
}

std::optional<Camera> camera_for(const RenderRequest& request, const Scene& scene, double aspect) {
    const Bounds bounds = bounds_of(scene);
    if (request.view.empty()) return scene.views.empty() ? overview(bounds, aspect) : camera_of(scene.views.front());
    for (const Standpoint standpoint : standpoints) {
        if (request.view == word_of(standpoint)) return camera_at(standpoint, bounds, aspect);
    }
    for (std::size_t k = 0; k < scene.views.size(); ++k) {
        if (scene.views[k].name == request.view || std::to_string(k + 1) == request.view)
            return camera_of(scene.views[k]);
    }
    return std::nullopt;
}

/// "z=1.2", "-x=0.5"; empty when it is no such plane.
std::optional<Cut> cut_named(std::string_view text) {
    const bool before = text.starts_with('-');
    if (before) text.remove_prefix(1);
    if (text.size() < 3 || text[0] < 'x' || text[0] > 'z' || text[1] != '=') return std::nullopt;
    Cut cut{Vec3(0.0), 0.0};
    cut.normal[text[0] - 'x'] = before ? -1.0 : 1.0;
    const auto [end, fault] = std::from_chars(text.data() + 2, text.data() + text.size(), cut.offset);
    if (fault != std::errc{} || end != text.data() + text.size() || !std::isfinite(cut.offset)) return std::nullopt;
    if (before) cut.offset = -cut.offset;
    return cut;
}

/// False when the plane is none; the reason is on stderr.
bool leave_out(const RenderRequest& request, LeftOut& left_out) {
    left_out.ceiling |= request.no_ceiling;
    if (request.cut.empty()) return true;
    left_out.cut = cut_named(request.cut);
    if (!left_out.cut)
        std::fprintf(stderr, "--cut: found \"%s\", allowed is an axis and a place in metres: z=1.2, or -z=1.2\n",
                     request.cut.c_str());
    return left_out.cut.has_value();
}

/// Part, scale and steps by their names, as the options' own check allows them; what is not asked for is
/// the project's.
ViewOptions options_for(const RenderRequest& request, const Scene& scene) {
    ViewOptions options;
    if (scene.colour_scale) take_scale(options, *scene.colour_scale);
    for (const LightPart part : {LightPart::total, LightPart::direct, LightPart::interreflected, LightPart::unshadowed})
        if (name_of(part) == request.part) options.part = part;
    for (const Scale scale : {Scale::false_colour, Scale::photo})
        if (name_of(scale) == request.scale) options.scale = scale;
    options.shadow_classes = request.part == "shadow-classes";
    options.shadow_outlines = request.shadow_outlines;
    options.values = options.pins = request.values;
    if (request.unit == "fc") options.unit = IlluminanceUnit::foot_candle;
    ColourScale asked = scale_of(options);
    if (!request.steps.empty()) asked.steps = request.steps;
    asked.marks_clipped |= request.marks_clipped;
    if (!request.isolux.empty()) asked.isolux = request.isolux;
    for (double& level : asked.isolux)
        if (!request.isolux.empty()) level *= lux_in(options.unit);
    std::sort(asked.isolux.begin(), asked.isolux.end());
    take_scale(options, asked);
    return options;
}

/// The luminaire whose shadows are asked for; the id of nothing for all. Empty when there is none such.
std::optional<ObjectId> luminaire_for(const std::string& wanted, const Scene& scene) {
    if (wanted.empty()) return ObjectId{};
    for (std::size_t k = 0; k < scene.luminaires.size(); ++k) {
        if (scene.luminaires[k].name == wanted || std::to_string(k + 1) == wanted) return scene.luminaires[k].id;
    }
    return std::nullopt;
}

void print_unknown_luminaire(const std::string& wanted, const Scene& scene) {
    std::fprintf(stderr, "--luminaire: no luminaire \"%s\"; there are 1 to %zu", wanted.c_str(),
                 scene.luminaires.size());
    for (const Luminaire& luminaire : scene.luminaires) std::fprintf(stderr, ", \"%s\"", luminaire.name.c_str());
    std::fputs("\n", stderr);
}

void print_unknown_view(const RenderRequest& request, const Scene& scene) {
    std::fprintf(stderr, "--view: no view \"%s\"; there are overview, plan, ceiling-plan, front, back, left, right",
                 request.view.c_str());
    for (const View& view : scene.views) std::fprintf(stderr, ", \"%s\"", view.name.c_str());
    std::fputs("\n", stderr);
}

/// The project's, or what the light reaches, unless the ends of the scale are given; false when those are
/// no range.
bool choose_range(const RenderRequest& request, const Solution& solution, LuxRange& range) {
    if (request.fits || !solution.scene->colour_scale) range = suggested_range(solution);
    if (request.low) range.low = *request.low;
    if (request.high) range.high = *request.high;
    if (range.low < range.high) return true;
    std::fprintf(stderr, "--low, --high: %g to %g lx is no range; low must be less than high\n", range.low, range.high);
    return false;
}

SolutionSnapshot solved(const SceneSnapshot& scene, const Settings& settings, const StudyRequest& wanted,
                        const std::stop_token& stop) {
    Progress progress;
    const ProgressLine line(progress);
    Study study;
    return study.run(scene, settings, wanted, Work{1, stop, &progress});
}

/// Null when stopped.
std::shared_ptr<const ExactPicture> exact_room_of(const SolutionSnapshot& solution, const ExactRequest& request,
                                                  int threads, const std::stop_token& stop) {
    using Clock = std::chrono::steady_clock;
    const auto begun = Clock::now();
    std::shared_ptr<const ExactPicture> room;
    {
        Progress progress;
        const ProgressLine line(progress);
        room = exact_room(solution, request, {threads > 0 ? threads : hardware_threads(), stop, &progress});
    }
    if (!room) return nullptr;
    std::fprintf(stderr, "direct light exact at %zu pixels, %zu of them with %d rays: %.2f s\n",
                 room->values.lux.size(), room->refined, request.samples,
                 std::chrono::duration<double>(Clock::now() - begun).count());
    return room;
}

/// SOURCE_DATE_EPOCH, for pictures that shall be the same at any time; else now.
std::chrono::system_clock::time_point present_time() {
    const char* const fixed = std::getenv("SOURCE_DATE_EPOCH");
    const long long seconds = fixed != nullptr ? std::atoll(fixed) : 0;
    return seconds > 0 ? std::chrono::system_clock::time_point(std::chrono::seconds(seconds))
                       : std::chrono::system_clock::now();
}

/// Where the picture goes: as it is named, or in that folder by the template. Empty, and said, when that makes
/// no sense.
std::filesystem::path file_for(const RenderRequest& request) {
    if (request.name_template.empty()) return request.out;
    const NameParts parts{request.project.stem().string(),
                          request.view.empty() ? "view" : request.view,
                          request.part == "four-up" ? "four parts" : request.part,
                          request.width,
                          request.height,
                          1,
                          present_time()};
    const PictureName name = picture_name(request.name_template, parts);
    if (!name.fault.empty()) std::fprintf(stderr, "--name-template: %s\n", name.fault.c_str());
    return name.fault.empty() ? request.out / name.name : std::filesystem::path();
}

/// The program ends here by the user's signal: nothing was written.
int ended_by(Interrupt& interrupt) {
    interrupt.pass_on();
    return exit_machine;
}

}  // namespace

int render_command(const RenderRequest& request) {
    const bool four_up = request.part == "four-up";
    if (four_up && request.exact) {
        std::fputs("--exact: not for --part four-up; ask for the four parts one by one\n", stderr);
        return exit_bad_input;
    }
    if (request.exact && request.part == "shadow-classes") {
        std::fputs("--exact: not for --part shadow-classes; classes are of whole patches\n", stderr);
        return exit_bad_input;
    }
    const std::filesystem::path file = file_for(request);
    if (file.empty()) return exit_bad_input;
    auto project = open_project(request.project);
    if (!project) return exit_bad_input;
    if (!recall_light_scene(project->scene, request.light_scene, request.project)) return exit_bad_input;
    const std::string hash = short_hash(project_text(*project));
    request.change(project->settings);
    const auto scene = std::make_shared<const Scene>(std::move(project->scene));
    PictureRequest picture;
    picture.options = options_for(request, *scene);
    picture.size = {request.width, request.height};
    picture.annotated = !request.plain;
    picture.has_scale_bar = !request.no_scale_bar;
    picture.has_axes = request.axes;
    picture.length = length_unit_named(request.length_unit);
    const auto camera = camera_for(request, *scene, view_size(picture).aspect());
    if (!camera) {
        print_unknown_view(request, *scene);
        return exit_bad_input;
    }
    picture.camera = *camera;
    if (!leave_out(request, picture.camera.left_out)) return exit_bad_input;
    const auto luminaire = luminaire_for(request.luminaire, *scene);
    if (!luminaire) {
        print_unknown_luminaire(request.luminaire, *scene);
        return exit_bad_input;
    }
    picture.options.shadows_of = *luminaire;

    StudyRequest wanted{.display = true};
    wanted.shadows = picture.options.shadow_classes || picture.options.shadow_outlines;
    wanted.unshadowed = four_up || picture.options.part == LightPart::unshadowed;
    Interrupt interrupt;
    const SolutionSnapshot solution = solved(scene, project->settings, wanted, interrupt.token());
    if (!solution) return ended_by(interrupt);
    if (!choose_range(request, *solution, picture.options.range)) return exit_bad_input;
    if (request.exact) {
        const ExactRequest exact{picture.camera, picture.options, view_size(picture), request.samples};
        picture.exact = exact_room_of(solution, exact, project->settings.threads, interrupt.token());
        if (!picture.exact) return ended_by(interrupt);
    }
    const OffscreenContext context;
    const Image image = four_up ? render_four_up(solution, picture) : render_picture(solution, picture);
    if (interrupt.came()) return ended_by(interrupt);
    write_png(image, file, picture_text(*solution, picture.options, hash, present_time()));
    return exit_done;
}

}  // namespace hanei
