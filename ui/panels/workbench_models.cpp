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
                      ask_about_model(file, false, {{file}, {}, {}, place, {}});
                  });
}

/// A file that holds lamps alone is hung, not stood.
void Workbench::ask_about_model(const std::filesystem::path& file, bool dropped, Arrival lamps_alone) {
    const auto show = [this, file, dropped, lamps_alone](Opened<ModelContent> opened) {
        const bool holds_lamps_alone =
            opened.content && !opened.content->scene.room && opened.content->solids == 0 && opened.content->sheets == 0;
        if (holds_lamps_alone) return receive(lamps_alone);
        if (!opened.content) return dialogs_.show_findings("This model cannot be imported", std::move(opened.findings));
        const auto read_again = [this, file](const ModelReading& how, ModelImport::Then then) {
            read_model(file, how, std::move(then));
        };
        model_import_.open(file, std::move(opened), read_again, lamps_alone.place, dropped,
                           [this](ModelImport::Taken taken) { take_model(std::move(taken)); });
    };
    read_model(file, {}, show);
}

void Workbench::read_model(const std::filesystem::path& file, const ModelReading& how, ModelImport::Then then) {
    file_work_.start(say("Reading {}", file.filename().string()),
                     [read = door_.read_model, file, how, then = std::move(then)](const Work&) {
                         const auto opened = std::make_shared<Opened<ModelContent>>(read(file, how));
                         return [opened, then] { then(std::move(*opened)); };
                     });
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
    browser_.open(
        {"Export glTF", "Export", {".glb", ".gltf"}, true, folder(), document_.title() + ".glb"},
        [this](const std::filesystem::path& file) {
            const SolutionSnapshot solution = study_.solution();
            if (!solution) return;
            file_work_.start(
                say("Exporting {}", file.filename().string()),
                [this, file, solution, write = door_.export_model, look = viewport_.state.options](const Work& work) {
                    const std::optional<Diagnostic> fault = write(*solution, look, file, work.stop);
                    return [this, file, fault] {
                        if (fault) return tell("Export", *fault);
                        message_ = say("Exported {}", file.filename().string());
                    };
                });
        });
}

}  // namespace hanei
