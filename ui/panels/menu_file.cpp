#include "engine/edit/edit.h"
#include "engine/edit/luminaire_edits.h"
#include "ui/panels/workbench.h"

#include <array>

namespace hanei {
namespace {

using enum CommandId;

constexpr std::array table{
    Command{new_project, "file.new", "File", "New...", "A room of your sizes, the plain room, or a copy of an example",
            control('N')},
    Command{open, "file.open", "File", "Open...", "Open a project", control('O')},
    Command{save, "file.save", "File", "Save", "Save the project under its name", control('S')},
    Command{save_as, "file.save_as", "File", "Save as...", "Save the project under another name", control('S', true)},
    Command{recover_work,
            "file.recover",
            "File",
            "Recover unsaved work...",
            "Look for work of windows that ended before it was saved",
            {}},
    Command{CommandId::start_page,
            "file.start_page",
            "File",
            "Start page...",
            "What the program begins with: new rooms, projects of before, examples",
            {}},
    Command{
        import_model,
        "file.import",
        "File",
        "Import glTF...",
        "Take furniture, a room and lamps from a model of another program (.gltf, .glb). Or drop the file on the room",
        {},
        {},
        true},
    Command{export_model,
            "file.export_model",
            "File",
            "Export glTF...",
            "Write the room for other programs, its light as colours as the view shows it",
            {}},
    Command{export_picture,
            "file.export",
            "File",
            "Export pictures...",
            "Write the view, or parts of its light, as PNG files with legend and caption",
            control('E'),
            {},
            true},
    Command{copy_picture, "file.copy_picture", "File", "Copy picture",
            "The view with legend and caption to the clipboard", control('C', true)},
    Command{export_values,
            "file.export_values",
            "File",
            "Export values...",
            "Every value of grids and points with its error, as CSV",
            {}},
    Command{toggle_recording,
            "file.record",
            "File",
            "Record pictures",
            "A numbered picture of every change of the view, from here until it is chosen again",
            {}},
    Command{render_exact, "file.render_exact", "File", "Render exact picture...",
            "Paint the view with direct light exact at every pixel, in the background, to look at and to save",
            control('R')},
    Command{quit, "file.quit", "File", "Quit", "Close the window", control('Q'), {}, true},
};

}  // namespace

std::span<const Command> file_menu() { return table; }

bool Workbench::can_file(CommandId id) const {
    switch (id) {
        case CommandId::recover_work:
            return static_cast<bool>(door_.user.recovery.lost);
        case CommandId::export_picture:
        case CommandId::copy_picture:
            return study_.solution() != nullptr;
        case CommandId::export_values:
            return study_.answer() != nullptr;
        case CommandId::import_model:
            return static_cast<bool>(door_.read_model);
        case CommandId::export_model:
            return study_.fresh() && door_.export_model;
        case CommandId::render_exact:
            return study_.fresh() && !viewport_.state.options.shadow_classes &&
                   has_part(*study_.solution(), viewport_.state.options.part);
        default:
            return true;
    }
}

void Workbench::do_file(CommandId id) {
    switch (id) {
        case CommandId::new_project:
            return guarded([this] { ask_new_project(); });
        case CommandId::open:
            return guarded([this] { open_file(); });
        case CommandId::save:
            return save(false);
        case CommandId::save_as:
            return save(true);
        case CommandId::recover_work:
            offer_recovery();
            if (!recovery_.is_open()) message_ = "There is no unsaved work to recover";
            return;
        case CommandId::start_page:
            return open_start_page();
        case CommandId::import_model:
            return import_model();
        case CommandId::export_model:
            return export_model();
        case CommandId::export_picture:
            return export_dialog_.open(folder(), preferences_.picture_name);
        case CommandId::copy_picture:
            copies_ = true;
            return;
        case CommandId::export_values:
            return ask_for_values();
        case CommandId::toggle_recording:
            return toggle_recording();
        case CommandId::render_exact:
            return exact_.start(study_.solution(), picture_request());
        case CommandId::quit:
            return ask_to_quit();
        default:
            return;
    }
}

}  // namespace hanei
