#include "ui/panels/command.h"

#include "engine/base/check.h"

#include <algorithm>
#include <array>

namespace hanei {
namespace {

using enum CommandId;

constexpr Chord plain(char capital) { return {key_of(capital)}; }
constexpr Chord control(char capital, bool shift = false) { return {key_of(capital), true, shift}; }

constexpr std::array table{
    Command{open, "file.open", "File", "Open...", "Open a project", control('O')},
    Command{save, "file.save", "File", "Save", "Save the project under its name", control('S')},
    Command{save_as, "file.save_as", "File", "Save as...", "Save the project under another name", control('S', true)},
    Command{export_picture,
            "file.export",
            "File",
            "Export picture...",
            "Write the view as two PNG files: with legend and caption, and plain",
            control('E'),
            {},
            true},
    Command{render_exact, "file.render_exact", "File", "Render exact picture...",
            "Paint the view with direct light exact at every pixel, in the background, to look at and to save",
            control('R')},
    Command{quit, "file.quit", "File", "Quit", "Close the window", control('Q'), {}, true},

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

    Command{add_panel_luminaire, "add.panel", "Add", "Panel luminaire", "A diffuse 0.6 m x 0.6 m ceiling panel", {}},
    Command{add_line_luminaire, "add.line", "Add", "Line luminaire", "A diffuse tube, 1.2 m long", {}},
    Command{add_point_luminaire, "add.point", "Add", "Point luminaire", "A small lamp shining evenly all around", {}},
    Command{add_luminaire_file, "add.file", "Add", "Luminaire from file...",
            "A luminaire as a file measures it: IES, EULUMDAT, TM-33, GLDF, glTF. Or drop the file on the room",
            control('L')},
    Command{add_box, "add.box", "Add", "Furniture box", "A box to stand on the floor", control('B'), {}, true},
    Command{add_grid, "add.grid", "Add", "Calculation grid", "A grid at desk height over the room", {}, {}, true},
    Command{add_calculation_point,
            "add.calculation_point",
            "Add",
            "Calculation point",
            "A single point at desk height, facing up",
            {}},

    Command{show_overview, "view.overview", "View", "Overview", "Show all of the room from above", {Key::home}},
    Command{show_plan, "view.plan", "View", "Plan", "Look straight down, to scale", plain('P')},
    Command{look_at_selection, "view.look", "View", "Centre on selection", "Turn about the selected object",
            plain('F')},
    Command{save_view, "view.save", "View", "Keep this view", "Add the present camera to the project's views",
            control('K')},
    Command{part_total, "view.total", "View", "Total light", "Direct and interreflected light", plain('1'), {}, true},
    Command{part_direct, "view.direct", "View", "Direct light", "Light straight from luminaires", plain('2')},
    Command{part_interreflected, "view.interreflected", "View", "Interreflected light",
            "Light by way of other surfaces", plain('3')},
    Command{part_unshadowed, "view.unshadowed", "View", "Without shadows", "All light as if nothing stood in its way",
            plain('4')},
    Command{four_up, "view.four_up", "View", "All four at once", "The four parts side by side, on one scale",
            plain('5')},
    Command{toggle_photo,
            "view.photo",
            "View",
            "As the eye sees it",
            "Photo-like picture instead of false colours",
            plain('C'),
            {},
            true},
    Command{toggle_shadow_classes, "view.shadow_classes", "View", "Shadow classes",
            "Patches that the selected luminaire (none: all together) lights wholly, in part or not at all",
            plain('H')},
    Command{toggle_shadow_outlines, "view.shadow_outlines", "View", "Shadow outlines",
            "Where the selected luminaire's shadows end (none: all luminaires'): umbra solid, penumbra dashed",
            plain('O')},
    Command{toggle_isolux, "view.isolux", "View", "Isolux lines", "Lines of equal illuminance", plain('I')},
    Command{toggle_mesh, "view.mesh", "View", "Patches", "Outlines of the patches", plain('M')},
    Command{toggle_grids, "view.grids", "View", "Calculation points", "Show where illuminance is reported", plain('N')},
    Command{toggle_body, "view.body", "View", "Photometric body",
            "The intensities of the selected luminaire as a body of wire", plain('B')},
    Command{fit_range, "view.fit_range", "View", "Fit the scale", "Fit the colour scale to the values in the room",
            plain('R')},

    Command{show_keys, "help.keys", "Help", "Keys and mouse", "This list", {Key::f1}, {Key::slash, false, true}},
    Command{show_about, "help.about", "Help", "About Hanei", "What this program is, and its licence", {}},
};

}  // namespace

std::span<const Command> commands() { return table; }

const Command& command(CommandId id) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const Command& entry) { return entry.id == id; });
    HANEI_CHECK(found != table.end());
    return *found;
}

const Command* command_for(const Chord& chord) {
    if (chord.key == Key::none) return nullptr;
    for (const Command& entry : table) {
        if (entry.chord == chord || entry.other == chord) return &entry;
    }
    return nullptr;
}

}  // namespace hanei
