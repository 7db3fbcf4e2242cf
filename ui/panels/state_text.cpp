#include "ui/panels/state_text.h"

#include "engine/edit/edit.h"
#include "ui/panels/measure_tool.h"

#include <fmt/format.h>
#include <numbers>

namespace hanei {
namespace {

std::string json_text(std::string_view text) {
    std::string json = "\"";
    for (const char letter : text) {
        if (letter == '"' || letter == '\\') json += '\\';
        if (static_cast<unsigned char>(letter) < 0x20)
            json += fmt::format("\\u{:04x}", static_cast<int>(letter));
        else
            json += letter;
    }
    return json + '"';
}

/// Figures stand as they are in JSON; words are quoted.
std::string json_value(const std::string& text) {
    if (text == "true" || text == "false") return text;
    const bool figure = !text.empty() && text.find_first_not_of("0123456789.+-e") == std::string::npos &&
                        text.find_first_of("0123456789") != std::string::npos;
    return figure ? text : json_text(text);
}

/// What the chosen luminaire is measured to shine.
void note_photometry(const Workbench& workbench, std::map<std::string, std::string>& state) {
    const Scene& scene = *workbench.document().shown();
    state["photometries"] = std::to_string(scene.photometries.size());
    state["readout"] = workbench.photometry().readout();
    const Luminaire* luminaire = find_luminaire(scene, workbench.chosen());
    if (luminaire == nullptr) return;
    state["yaw"] = fmt::format("{:.6f}", luminaire->yaw * 180.0 / std::numbers::pi);
    const Photometry* photometry = photometry_of(scene, *luminaire);
    if (photometry == nullptr) return;
    const auto* flux = std::get_if<LuminousFlux>(&luminaire->output);
    state["photometry"] = photometry->name;
    state["flux"] = flux != nullptr ? fmt::format("{}", flux->value) : "as measured";
    state["quarter turns"] = std::to_string(photometry->quarter_turns);
    state["lamp set"] = std::to_string(photometry->lamp_set);
}

const char* truth(bool value) { return value ? "true" : "false"; }

void note_readings(const Readings& readings, std::map<std::string, std::string>& state) {
    if (const auto& made = readings.why.contributions()) {
        state["why total"] = fmt::format("{}", made->value.total().value);
        if (!made->luminaires.empty()) state["why first luminaire"] = rows_by_luminaire(*made).front().name;
    }
    state["kept states"] = std::to_string(readings.snapshots.list().size());
    state["shows"] = readings.snapshots.shows_difference() ? "difference"
                     : readings.snapshots.shows_kept()     ? "kept"
                                                           : "now";
}

}  // namespace

std::map<std::string, std::string> state_of(const Workbench& workbench) {
    const Document& document = workbench.document();
    const LiveStudy& study = workbench.study();
    const Scene& scene = *document.shown();
    std::map<std::string, std::string> state;
    state["frame"] = std::to_string(workbench.frames());
    state["exact"] = workbench.exact().busy() ? "painting" : workbench.exact().shown() != nullptr ? "shown" : "none";
    state["settled"] = truth(study.settled() && !document.in_gesture());
    state["fresh"] = truth(study.fresh());
    state["busy"] = truth(study.busy());
    state["answer ms"] = fmt::format("{:.1f}", 1000.0 * study.answer_seconds());
    state["undo depth"] = std::to_string(document.history().depth());
    state["undo"] = document.history().undo_name();
    state["saved"] = truth(document.is_saved());
    state["title"] = document.title();
    state["message"] = workbench.message();
    state["dialog"] = std::string(name_of(workbench.dialogs().kind()));
    state["finding"] =
        workbench.dialogs().shown_findings().empty() ? "" : workbench.dialogs().shown_findings().front().message;
    state["recovery"] = std::to_string(workbench.recovery().is_open() ? workbench.recovery().offers().size() : 0);
    state["messages"] = std::to_string(workbench.messages().entries().size());
    state["start page"] = truth(workbench.start_page().is_open());
    state["asks"] = truth(workbench.furnishing().is_asking());
    state["browser"] = truth(workbench.browser().is_open());
    state["model"] = workbench.model_import().summary();
    state["snap"] = truth(workbench.is_snapping());
    state["part"] = workbench.viewport().state.panes.shows_parts()
                        ? "four"
                        : std::string(name_of(workbench.viewport().state.options.part));
    state["shadow classes"] = truth(workbench.viewport().state.options.shadow_classes);
    state["shadow outlines"] = truth(workbench.viewport().state.options.shadow_outlines);
    state["scale"] = std::string(name_of(workbench.viewport().state.options.scale));
    state["range.low"] = fmt::format("{}", workbench.viewport().state.options.range.low);
    state["range.high"] = fmt::format("{}", workbench.viewport().state.options.range.high);
    state["probe"] = workbench.viewport().probe() ? workbench.viewport().probe()->text() : "";
    if (const auto* const tool = dynamic_cast<const MeasureTool*>(workbench.viewport().tool())) {
        const std::optional<Vec3> between = tool->distance();
        state["measured"] = between ? fmt::format("{:.6f}", glm::length(*between)) : "";
    }
    state["walking"] = truth(workbench.is_on(CommandId::walk_through));
    const Camera& camera = workbench.viewport().state.camera;
    for (int axis = 0; axis < 3; ++axis)
        state[fmt::format("eye.{}", "xyz"[axis])] = fmt::format("{}", camera.eye[axis]);
    state["field of view"] = fmt::format("{:.6f}", camera.field_of_view * 180.0 / std::numbers::pi);
    state["scale kept"] = truth(scene.colour_scale.has_value());
    state["scale steps"] = std::string(name_of(workbench.viewport().state.options.steps));
    note_readings(workbench.readings(), state);
    state["luminaires"] = std::to_string(scene.luminaires.size());
    state["furniture"] = std::to_string(scene.furniture.size());
    state["selected count"] = std::to_string(workbench.selection().ids().size());
    state["selected"] = display_name(scene, workbench.chosen());
    if (const auto place = place_of(scene, workbench.chosen())) {
        state["selected.x"] = fmt::format("{}", place->x);
        state["selected.y"] = fmt::format("{}", place->y);
        state["selected.z"] = fmt::format("{}", place->z);
    }
    note_photometry(workbench, state);
    if (!study.solution()) return state;
    const Solution& solution = *study.solution();
    state["converged"] = truth(solution.converged);
    state["bounces"] = std::to_string(solution.bounces);
    for (const StageTime& stage : solution.times) {
        state["ms " + std::string(name_of(stage.stage))] = stage.reused ? "reused" : fmt::format("{:.1f}", stage.ms);
    }
    for (const GridResult& grid : solution.grids) {
        const GridFigures figures = figures_of(grid);
        const std::string name = "grid " + display_name(*solution.scene, grid.grid);
        state[name + " mean"] = fmt::format("{}", figures.mean);
        state[name + " min"] = fmt::format("{}", figures.min);
        state[name + " uniformity"] = fmt::format("{}", figures.uniformity);
    }
    for (const PointResult& point : solution.points) {
        state["point " + display_name(*solution.scene, point.point)] = fmt::format("{}", point.value.total().value);
    }
    return state;
}

std::string state_json(const Workbench& workbench) {
    std::string json = "{\n";
    for (const auto& [name, value] : state_of(workbench))
        json += fmt::format("  {}: {},\n", json_text(name), json_value(value));
    json += "  \"widgets\": {";
    const char* comma = "\n";
    for (const auto& [name, rect] : workbench.widgets().all()) {
        json += fmt::format("{}    {}: [{:.1f}, {:.1f}, {:.1f}, {:.1f}]", comma, json_text(name), rect.left, rect.top,
                            rect.right, rect.bottom);
        comma = ",\n";
    }
    json += "\n  },\n  \"objects\": {";
    comma = "\n";
    const Scene& scene = *workbench.document().shown();
    const auto list = [&](const auto& objects) {
        for (const auto& object : objects) {
            const auto place = place_of(scene, object.id);
            const auto at = place ? workbench.viewport().on_screen(*place) : std::nullopt;
            if (!at) continue;
            json += fmt::format("{}    {}: [{:.1f}, {:.1f}]", comma, json_text(display_name(scene, object.id)), at->x,
                                at->y);
            comma = ",\n";
        }
    };
    list(scene.luminaires);
    list(scene.furniture);
    list(scene.points);
    return json + "\n  }\n}\n";
}

}  // namespace hanei
