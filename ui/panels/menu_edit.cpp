#include "engine/edit/excerpt.h"
#include "engine/edit/luminaire_edits.h"
#include "ui/panels/box_tool.h"
#include "ui/panels/workbench.h"

#include <array>
#include <numbers>

namespace hanei {
namespace {

using enum CommandId;

constexpr std::array table{
    Command{undo, "edit.undo", "Edit", "Undo", "Take back the last change", control('Z')},
    Command{redo, "edit.redo", "Edit", "Redo", "Make the change again that was taken back", control('Y'),
            control('Z', true)},
    Command{show_history, "edit.history", "Edit", "History...", "All steps by name; a click goes there", control('H')},
    Command{cut, "edit.cut", "Edit", "Cut", "Copy what is selected, and remove it", control('X'), {}, true},
    Command{copy, "edit.copy", "Edit", "Copy",
            "What is selected, with its materials and photometry, for this or another project", control('C')},
    Command{CommandId::paste, "edit.paste", "Edit", "Paste", "What was copied, where the pointer is", control('V')},
    Command{duplicate, "edit.duplicate", "Edit", "Duplicate", "Copy what is selected beside itself", control('D')},
    Command{remove, "edit.delete", "Edit", "Delete", "Remove what is selected", {Key::del}},
    Command{select_all,
            "edit.select_all",
            "Edit",
            "Select all",
            "Everything that stands or hangs in the room",
            control('A'),
            {},
            true},
    Command{select_same, "edit.select_same", "Edit", "Select same kind",
            "All objects of the kinds that are selected: of one luminaire all luminaires", control('A', true)},
    Command{
        box_select, "edit.box_select", "Edit", "Select by a box",
        "Draw a box: to the right it takes what it encloses, to the left what it touches. Or Shift+drag at any time",
        plain('B')},
    Command{deselect,
            "edit.deselect",
            "Edit",
            "Select nothing",
            "Let go of the selection. With nothing selected: stop computing light",
            {Key::escape}},
    Command{turn_object,
            "edit.turn",
            "Edit",
            "Turn by 90°",
            "Turn what is selected about its middle, counter-clockwise from above",
            plain('T'),
            {},
            true},
    Command{turn_intensities,
            "edit.turn_intensities",
            "Edit",
            "Turn intensities by 90°",
            "Turn the light of the selected luminaire against its housing",
            {key_of('T'), false, true}},
    Command{toggle_snap,
            "edit.snap",
            "Edit",
            "Snap",
            "Moved objects catch at the raster, walls, centre lines and each other; Ctrl while dragging does the "
            "opposite",
            plain('G'),
            {},
            true},
    Command{snap_settings,
            "edit.snap_settings",
            "Edit",
            "Snapping...",
            "The raster, and what moved objects catch at",
            {key_of('G'), false, true}},
    Command{nudge_left,
            "edit.nudge_left",
            "",
            "Nudge -x",
            "Move the selection 0.1 m towards -x (Shift: 0.01 m)",
            {Key::left},
            {Key::left, false, true}},
    Command{nudge_right,
            "edit.nudge_right",
            "",
            "Nudge +x",
            "Move the selection 0.1 m towards +x (Shift: 0.01 m)",
            {Key::right},
            {Key::right, false, true}},
    Command{nudge_down,
            "edit.nudge_down",
            "",
            "Nudge -y",
            "Move the selection 0.1 m towards -y (Shift: 0.01 m)",
            {Key::down},
            {Key::down, false, true}},
    Command{nudge_up,
            "edit.nudge_up",
            "",
            "Nudge +y",
            "Move the selection 0.1 m towards +y (Shift: 0.01 m)",
            {Key::up},
            {Key::up, false, true}},
    Command{nudge_lower,
            "edit.nudge_lower",
            "",
            "Nudge -z",
            "Lower the selection 0.1 m (Shift: 0.01 m)",
            {Key::page_down},
            {Key::page_down, false, true}},
    Command{nudge_higher,
            "edit.nudge_higher",
            "",
            "Nudge +z",
            "Raise the selection 0.1 m (Shift: 0.01 m)",
            {Key::page_up},
            {Key::page_up, false, true}},
    Command{edit_preferences,
            "edit.preferences",
            "Edit",
            "Preferences...",
            "Language, look, units and how work is kept",
            {Key::comma, true},
            {},
            true},
};

}  // namespace

std::span<const Command> edit_menu() { return table; }

bool Workbench::can_edit(CommandId id) const {
    const Scene& scene = *document_.shown();
    switch (id) {
        case CommandId::undo:
            return document_.history().can_undo();
        case CommandId::redo:
            return document_.history().can_redo();
        case CommandId::cut:
        case CommandId::copy:
            return door_.text && can_remove(scene, selection_.ids());
        case CommandId::paste:
            return door_.read_text != nullptr;
        case CommandId::duplicate:
        case CommandId::remove:
            return can_remove(scene, selection_.ids());
        case CommandId::select_all:
            return !all_objects(scene).empty();
        case CommandId::select_same:
            return !selection_.empty();
        case CommandId::deselect:
            return !selection_.empty() || study_.is_cancellable();
        case CommandId::nudge_left:
        case CommandId::nudge_right:
        case CommandId::nudge_down:
        case CommandId::nudge_up:
        case CommandId::nudge_lower:
        case CommandId::nudge_higher:
        case CommandId::turn_object:
            return middle_of(scene, selection_.ids()).has_value();
        case CommandId::turn_intensities: {
            const Luminaire* luminaire = find_luminaire(scene, selection_.primary());
            return luminaire != nullptr && photometry_of(scene, *luminaire) != nullptr;
        }
        default:
            return true;
    }
}

void Workbench::do_edit(CommandId id) {
    const Scene& scene = *document_.shown();
    switch (id) {
        case CommandId::undo:
            return document_.undo();
        case CommandId::redo:
            return document_.redo();
        case CommandId::show_history:
            return history_list_.open();
        case CommandId::cut:
            copy_chosen();
            return do_edit(CommandId::remove);
        case CommandId::copy:
            return copy_chosen();
        case CommandId::paste:
            return paste();
        case CommandId::snap_settings:
            return snap_popup_.open();
        case CommandId::duplicate:
            return add(duplicated(scene, selection_.ids()), "Duplicate " + words_for(scene, selection_.ids()));
        case CommandId::remove:
            document_.commit(removed(scene, selection_.ids()),
                             "Delete " + (selection_.ids().size() == 1 ? display_name(scene, selection_.primary())
                                                                       : words_for(scene, selection_.ids())));
            selection_.clear();
            return;
        case CommandId::select_all:
            return choose(all_objects(scene));
        case CommandId::select_same:
            return choose(same_kind(scene, selection_.ids()));
        case CommandId::box_select:
            return viewport_.take_up(std::make_unique<BoxTool>(viewport_.state.options.grids));
        case CommandId::deselect:
            if (selection_.empty()) return study_.cancel();
            selection_.clear();
            return;
        case CommandId::toggle_snap:
            snap_.on = !snap_.on;
            return;
        case CommandId::nudge_left:
            return nudge({-1.0, 0.0, 0.0});
        case CommandId::nudge_right:
            return nudge({1.0, 0.0, 0.0});
        case CommandId::nudge_down:
            return nudge({0.0, -1.0, 0.0});
        case CommandId::nudge_up:
            return nudge({0.0, 1.0, 0.0});
        case CommandId::nudge_lower:
            return nudge({0.0, 0.0, -1.0});
        case CommandId::nudge_higher:
            return nudge({0.0, 0.0, 1.0});
        case CommandId::turn_object:
            document_.commit(
                turned(scene, selection_.ids(), *middle_of(scene, selection_.ids()), 0.5 * std::numbers::pi),
                "Turn " + words_for(scene, selection_.ids()) + " by 90 degrees");
            return;
        case CommandId::edit_preferences:
            return preferences_dialog_.open();
        case CommandId::turn_intensities: {
            Photometry turned =
                turned_by_a_quarter(*photometry_of(scene, *find_luminaire(scene, selection_.primary())));
            document_.commit(with_photometry(scene, selection_.primary(), std::move(turned), photometry_.reaches_all()),
                             "Turn intensities by 90 degrees");
            return;
        }
        default:
            return;
    }
}

}  // namespace hanei
