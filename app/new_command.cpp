#include "app/new_command.h"

#include "app/exit_code.h"
#include "app/files.h"
#include "engine/edit/furniture_edits.h"
#include "engine/edit/plan_edits.h"
#include "engine/edit/plan_shape.h"
#include "engine/edit/sub_areas.h"
#include "engine/scene/scene_check.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <fmt/format.h>
#include <numbers>

namespace hanei {
namespace {

Diagnostic fault(std::string_view option, std::string message) {
    return {Severity::error, {"", 0, std::string(option), 0}, std::move(message)};
}

/// Figures between separators; nothing when one of them is none.
std::optional<std::vector<double>> figures_of(std::string_view text, char separator) {
    std::vector<double> figures;
    while (true) {
        const std::size_t end = std::min(text.find(separator), text.size());
        double value = 0.0;
        const auto read = std::from_chars(text.data(), text.data() + end, value);
        if (read.ec != std::errc() || read.ptr != text.data() + end || !std::isfinite(value)) return std::nullopt;
        figures.push_back(value);
        if (end == text.size()) return figures;
        text.remove_prefix(end + 1);
    }
}

std::vector<std::string_view> words_of(std::string_view text, char separator) {
    std::vector<std::string_view> words;
    while (true) {
        const std::size_t end = std::min(text.find(separator), text.size());
        words.push_back(text.substr(0, end));
        if (end == text.size()) return words;
        text.remove_prefix(end + 1);
    }
}

template <class Kinds>
std::string kinds_text(const Kinds& kinds) {
    std::string text;
    for (const auto& kind : kinds) text += (text.empty() ? "" : ", ") + std::string(kind.kind);
    return text;
}

std::optional<Scene> room_of(const NewRequest& request, Diagnostics& faults) {
    NewRoom wished;
    wished.shape = request.shape;
    if (!request.room.empty()) {
        const auto sizes = figures_of(request.room, 'x');
        const bool good = sizes && sizes->size() == 3 && std::all_of(sizes->begin(), sizes->end(), [](double size) {
                              return size >= 0.1 && size <= 1000.0;
                          });
        if (!good) {
            faults.push_back(fault("--room", fmt::format("found \"{}\", expected LENGTHxWIDTHxHEIGHT in metres, each "
                                                         "0.1 to 1000, as 6x4x2.8",
                                                         request.room)));
            return std::nullopt;
        }
        wished.length = (*sizes)[0];
        wished.width = (*sizes)[1];
        wished.height = (*sizes)[2];
    }
    const auto reflectances = reflectances_of(std::string_view(request.reflectances));
    if (!reflectances) {
        faults.push_back(fault("--reflectances", fmt::format("found \"{}\", expected percentages of ceiling, walls and "
                                                             "floor, each 0 to 100, as 70/50/20",
                                                             request.reflectances)));
        return std::nullopt;
    }
    wished.reflectances = *reflectances;
    Scene scene = new_room(wished);
    if (request.plan.empty()) return scene;
    const std::vector<Vec2> plan = plan_of_text(request.plan);
    PlanEdit drawn = with_plan(scene, plan);
    if (plan.empty())
        drawn.message = fmt::format("found \"{}\", expected corners in metres, as \"0,0 6,0 6,4 0,4\"", request.plan);
    if (plan.empty() || !drawn.scene) {
        faults.push_back(fault("--plan", drawn.message));
        return std::nullopt;
    }
    return std::move(drawn.scene);
}

/// "desk:width=1.8,depth=0.7@1.5,2.0,90": sizes and place may be left out.
void add_furniture(Scene& scene, const std::string& text, Diagnostics& faults) {
    const auto refuse = [&](std::string message) { faults.push_back(fault("--furniture", std::move(message))); };
    const std::vector<std::string_view> halves = words_of(text, '@');
    const std::vector<std::string_view> named = words_of(halves[0], ':');
    const FurnitureKind* const kind = find_furniture_kind(named[0]);
    if (kind == nullptr)
        return refuse(fmt::format("there is no \"{}\"; there are {}", named[0], kinds_text(furniture_library())));
    FurnitureModel model{std::string(kind->kind), {}};
    for (const std::string_view size : named.size() > 1 ? words_of(named[1], ',') : std::vector<std::string_view>()) {
        const std::vector<std::string_view> pair = words_of(size, '=');
        const auto value = pair.size() == 2 ? figures_of(pair[1], ',') : std::nullopt;
        const FurnitureSize* const known = find_size(*kind, pair[0]);
        if (known == nullptr || !value)
            return refuse(fmt::format("found \"{}\" of a {}, expected a size and its metres, as {}={}", size,
                                      kind->kind, kind->sizes[0].name, kind->sizes[0].usual));
        if (!(value->front() >= known->low && value->front() <= known->high))
            return refuse(fmt::format("found a {} of {:g} for a {}, allowed is {:g} to {:g}", known->name,
                                      value->front(), kind->kind, known->low, known->high));
        model.sizes.push_back({std::string(pair[0]), value->front()});
    }
    if (halves.size() == 1) {
        scene = with_furniture(std::move(scene), model).scene;
        return;
    }
    const auto place = halves.size() == 2 ? figures_of(halves[1], ',') : std::nullopt;
    if (!place || place->size() < 2 || place->size() > 4)
        return refuse(fmt::format("found \"{}\", expected KIND@X,Y, KIND@X,Y,DEGREES or KIND@X,Y,DEGREES,Z", text));
    const double degrees = place->size() > 2 ? (*place)[2] : 0.0;
    const double z = place->size() > 3 ? (*place)[3] : scene.room->floor_height;
    scene = with_furniture(std::move(scene), model, {(*place)[0], (*place)[1], z}, degrees * std::numbers::pi / 180.0)
                .scene;
}

/// "window:2@1.5": kind, wall counted from 1 (or "floor"), and the middle's place along it.
void add_opening(Scene& scene, const std::string& text, Diagnostics& faults) {
    const auto refuse = [&](std::string message) { faults.push_back(fault("--opening", std::move(message))); };
    const std::vector<std::string_view> halves = words_of(text, '@');
    const std::vector<std::string_view> named = words_of(halves[0], ':');
    const SubAreaKind* const kind = find_sub_area_kind(named[0]);
    if (kind == nullptr)
        return refuse(fmt::format("there is no \"{}\"; there are {}", named[0], kinds_text(sub_area_kinds())));
    const auto wall = named.size() == 2 ? figures_of(named[1], ',') : std::nullopt;
    const int walls = static_cast<int>(scene.room->plan.size());
    const bool on_floor = kind->level && named.size() == 1;
    const bool good = on_floor || (wall && wall->front() == std::floor(wall->front()) && wall->front() >= 1.0 &&
                                   wall->front() <= walls);
    if (!good) return refuse(fmt::format("found \"{}\", expected KIND:WALL with a wall from 1 to {}", text, walls));
    const int face = on_floor ? Room::floor_face : Room::wall_face(static_cast<int>(wall->front()) - 1);
    const auto middle = halves.size() == 2 ? figures_of(halves[1], ',') : std::nullopt;
    if (halves.size() > 1 && (!middle || middle->size() != 1))
        return refuse(fmt::format("found \"{}\", expected KIND:WALL@METRES along the wall", text));
    Added added = middle ? with_sub_area(std::move(scene), *kind, face, middle->front())
                         : with_sub_area(std::move(scene), *kind, face);
    scene = std::move(added.scene);
    if (!added.object) refuse(fmt::format("there is no room for \"{}\" on its wall", text));
}

int list_kinds() {
    for (const FurnitureKind& kind : furniture_library()) {
        fmt::print("{:18}{}\n", kind.kind, kind.help);
        for (const FurnitureSize& size : kind.sizes)
            fmt::print("    {:14}{:g} to {:g}, usually {:g}{}\n", size.name, size.low, size.high, size.usual,
                       size.counts ? "" : " m");
    }
    fmt::print("\nOn walls (--opening): {}\n", kinds_text(sub_area_kinds()));
    return exit_done;
}

}  // namespace

int new_command(const NewRequest& request) {
    if (request.lists) return list_kinds();
    Diagnostics findings;
    if (request.out.empty()) findings.push_back(fault("OUT", "name the project file to write, as room.hanei"));
    std::optional<Scene> scene = room_of(request, findings);
    if (scene) {
        for (const std::string& text : request.openings) add_opening(*scene, text, findings);
        for (const std::string& text : request.furniture) add_furniture(*scene, text, findings);
        const Diagnostics checked = check_scene(*scene);
        findings.insert(findings.end(), checked.begin(), checked.end());
    }
    print_findings(findings);
    if (has_errors(findings)) return exit_bad_input;
    scene->title = request.out.stem().string();
    if (const auto unwritten = write_project({std::move(*scene), {}}, request.out)) {
        print_findings({*unwritten});
        return exit_machine;
    }
    return exit_done;
}

}  // namespace hanei
