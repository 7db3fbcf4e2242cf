#include "engine/edit/edit.h"
#include "engine/edit/luminaire_edits.h"
#include "ui/panels/workbench.h"

#include <array>

namespace hanei {
namespace {

using enum CommandId;

constexpr std::array table{
    Command{undo, "edit.undo", "Edit", "Undo", "Take back the last change", control('Z')},
    Command{redo, "edit.redo", "Edit", "Redo", "Make the change again that was taken back", control('Y'),
            control('Z', true)},
    Command{duplicate,
            "edit.duplicate",
            "Edit",
            "Duplicate",
            "Copy the selected object beside itself",
            control('D'),
            {},
            true},
    Command{remove, "edit.delete", "Edit", "Delete", "Remove the selected object", {Key::del}},
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
            "Turn the selected luminaire or furniture about the vertical",
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
            "Snap to 0.1 m",
            "Moved objects keep to a 0.1 m raster; Ctrl while dragging does the opposite",
            plain('G'),
            {},
            true},
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
};

}  // namespace

std::span<const Command> edit_menu() { return table; }

bool Workbench::can_edit(CommandId id) const {
    const ObjectKind kind = kind_of(*document_.shown(), selection_.primary());
    switch (id) {
        case CommandId::undo:
            return document_.history().can_undo();
        case CommandId::redo:
            return document_.history().can_redo();
        case CommandId::duplicate:
            return can_remove(kind);
        case CommandId::remove:
            return can_remove(kind);
        case CommandId::deselect:
            return static_cast<bool>(selection_.primary()) || study_.is_cancellable();
        case CommandId::nudge_left:
        case CommandId::nudge_right:
        case CommandId::nudge_down:
        case CommandId::nudge_up:
        case CommandId::nudge_lower:
        case CommandId::nudge_higher:
            return place_of(*document_.shown(), selection_.primary()).has_value();
        case CommandId::turn_object:
            return kind == ObjectKind::luminaire || kind == ObjectKind::furniture;
        case CommandId::turn_intensities: {
            const Luminaire* luminaire = find_luminaire(*document_.shown(), selection_.primary());
            return luminaire != nullptr && photometry_of(*document_.shown(), *luminaire) != nullptr;
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
        case CommandId::duplicate:
            return add(duplicated(scene, selection_.primary()), "Duplicate");
        case CommandId::remove:
            document_.commit(removed(scene, selection_.primary()),
                             "Delete " + display_name(scene, selection_.primary()));
            selection_.clear();
            return;
        case CommandId::deselect:
            if (!selection_.primary()) return study_.cancel();
            selection_.clear();
            return;
        case CommandId::toggle_snap:
            snaps_ = !snaps_;
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
            document_.commit(turned_by_a_quarter(scene, selection_.primary()),
                             "Turn " + std::string(name_of(kind_of(scene, selection_.primary()))) + " by 90 degrees");
            return;
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
