#include "engine/edit/edit.h"
#include "engine/edit/join.h"
#include "ui/panels/hanging.h"
#include "ui/panels/language.h"
#include "ui/panels/workbench.h"

#include <fmt/format.h>

namespace hanei {

void Workbench::import_model() {
    browser_.open({"Import a glTF model", "Import", {".gltf", ".glb"}, false, folder(), ""},
                  [this](const std::filesystem::path& file) {
                      const Vec2 place = place_in_plan(*document_.shown(), {}, raster());
                      if (!ask_about_model(file, place, false)) receive({{file}, {}, {}, place, {}});
                  });
}

/// False when the file holds lamps alone: those are hung, not stood.
bool Workbench::ask_about_model(const std::filesystem::path& file, Vec2 place, bool dropped) {
    Opened<ModelContent> opened = door_.read_model(file, {});
    const bool holds_lamps_alone =
        opened.content && !opened.content->scene.room && opened.content->solids == 0 && opened.content->sheets == 0;
    if (holds_lamps_alone) return false;
    if (!opened.content) {
        dialogs_.show_findings("This model cannot be imported", std::move(opened.findings));
        return true;
    }
    const auto read = [this, file](const ModelReading& how) { return door_.read_model(file, how); };
    model_import_.open(file, std::move(opened), read, place, dropped,
                       [this](ModelImport::Taken taken) { take_model(std::move(taken)); });
    return true;
}

/// The empty room comes first in the history: the project is unsaved from the start.
void Workbench::start_with_model(ModelImport::Taken taken) {
    const std::string name = taken.file.filename().string();
    Scene scene = std::move(taken.content.scene);
    const Settings settings = taken.content.settings.value_or(Settings{});
    if (scene.title.empty()) scene.title = taken.file.stem().string();
    show(Document({empty_room(), {}}));
    document_.commit(ProjectContent{std::move(scene), settings}, "Import " + name);
    message_ = say("Imported {} as a new project", name);
}

void Workbench::take_model(ModelImport::Taken taken) {
    using Where = ModelImport::Where;
    if (taken.where == Where::new_project)
        return guarded([this, model = std::move(taken)]() mutable { start_with_model(std::move(model)); });
    const Scene present = *document_.shown();
    const double floor = present.room ? present.room->floor_height : 0.0;
    const bool brings_room = taken.content.scene.room.has_value();
    Scene model = std::move(taken.content.scene);
    if (taken.where == Where::middle || taken.where == Where::pointer)
        model = stood_at(std::move(model), taken.place, floor);
    const Scene into = taken.where == Where::instead ? emptied(present) : present;
    const std::string name = taken.file.filename().string();
    document_.commit(joined(into, model), "Import " + name);
    const Scene& now = *document_.shown();
    selection_.clear();
    if (!brings_room && now.furniture.size() > into.furniture.size())
        selection_.choose(now.furniture[into.furniture.size()].id);
    else if (!brings_room && now.surfaces.size() > into.surfaces.size())
        selection_.choose(now.surfaces[into.surfaces.size()].id);
    if (brings_room) {
        shows_overview_ = true;
        readings_.scale.forget();
    }
    const std::size_t remarks = taken.findings.size();
    message_ = say("Imported {}", name);
    if (remarks > 0) message_ += say(remarks == 1 ? " · {} remark on its file" : " · {} remarks on its file", remarks);
}

void Workbench::export_model() {
    browser_.open({"Export glTF", "Export", {".glb", ".gltf"}, true, folder(), document_.title() + ".glb"},
                  [this](const std::filesystem::path& file) {
                      const SolutionSnapshot solution = study_.solution();
                      if (!solution) return;
                      if (const auto fault = door_.export_model(*solution, viewport_.state.options, file))
                          return tell("Export", *fault);
                      message_ = say("Exported {}", file.filename().string());
                  });
}

}  // namespace hanei
