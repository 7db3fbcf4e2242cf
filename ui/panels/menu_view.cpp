#include "engine/edit/edit.h"
#include "engine/edit/luminaire_edits.h"
#include "ui/panels/workbench.h"

#include <array>

namespace hanei {
namespace {

using enum CommandId;

constexpr std::array table{
    Command{show_overview, "view.overview", "View", "Overview", "Show all of the room from above", {Key::home}},
    Command{show_plan, "view.plan", "View", "Plan", "Look straight down, to scale", plain('P'), {Key::keypad_7}},
    Command{show_ceiling_plan,
            "view.ceiling_plan",
            "View",
            "Ceiling plan",
            "The ceiling as a mirror on the floor shows it, over the plan and to scale",
            {key_of('P'), false, true},
            {Key::keypad_7, true}},
    Command{show_front,
            "view.front",
            "View",
            "Front",
            "Look from -y through the front wall, to scale",
            {Key::keypad_1},
            {key_of('F'), false, true}},
    Command{
        show_back, "view.back", "View", "Back", "Look from +y through the back wall, to scale", {Key::keypad_1, true}},
    Command{
        show_right, "view.right", "View", "Right", "Look from +x through the right wall, to scale", {Key::keypad_3}},
    Command{
        show_left, "view.left", "View", "Left", "Look from -x through the left wall, to scale", {Key::keypad_3, true}},
    Command{toggle_orthographic,
            "view.orthographic",
            "View",
            "To scale",
            "Parallel projection in place of perspective, and back; what is in the middle keeps its size",
            {Key::keypad_5}},
    Command{look_at_selection, "view.look", "View", "Centre on selection", "Turn about the selected object",
            plain('F')},
    Command{save_view, "view.save", "View", "Keep this view", "Add the present camera to the project's views",
            control('K')},
    Command{split_view,
            "view.split",
            "View",
            "Two pictures",
            "Two pictures side by side, each from where you like; once more: one",
            plain('6'),
            {},
            true},
    Command{four_views, "view.four_views", "View", "Plan, front, side, perspective",
            "Four pictures as in a drawing; once more: one", plain('7')},
    Command{part_total, "view.total", "View", "Total light", "Direct and interreflected light", plain('1'), {}, true},
    Command{part_direct, "view.direct", "View", "Direct light", "Light straight from luminaires", plain('2')},
    Command{part_interreflected, "view.interreflected", "View", "Interreflected light",
            "Light by way of other surfaces", plain('3')},
    Command{part_unshadowed, "view.unshadowed", "View", "Without shadows", "All light as if nothing stood in its way",
            plain('4')},
    Command{four_up, "view.four_up", "View", "All four at once",
            "The four parts of the light side by side, on one scale", plain('5')},
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
    Command{toggle_body,
            "view.body",
            "View",
            "Photometric body",
            "The intensities of the selected luminaire as a body of wire",
            {key_of('B'), false, true}},
    Command{fit_range, "view.fit_range", "View", "Fit the scale", "Fit the colour scale to the values in the room",
            plain('R')},
};

}  // namespace

std::span<const Command> view_menu() { return table; }

bool Workbench::can_view(CommandId id) const {
    switch (id) {
        case CommandId::look_at_selection:
            return place_of(*document_.shown(), selection_.primary()).has_value();
        case CommandId::fit_range:
            return study_.solution() != nullptr;
        default:
            return true;
    }
}

void Workbench::do_view(CommandId id) {
    const Scene& scene = *document_.shown();
    ViewState& view = viewport_.state;
    switch (id) {
        case CommandId::show_overview:
            return viewport_.look_from(Standpoint::overview, scene);
        case CommandId::show_plan:
            return viewport_.look_from(Standpoint::plan, scene);
        case CommandId::show_ceiling_plan:
            return viewport_.look_from(Standpoint::ceiling_plan, scene);
        case CommandId::show_front:
            return viewport_.look_from(Standpoint::front, scene);
        case CommandId::show_back:
            return viewport_.look_from(Standpoint::back, scene);
        case CommandId::show_left:
            return viewport_.look_from(Standpoint::left, scene);
        case CommandId::show_right:
            return viewport_.look_from(Standpoint::right, scene);
        case CommandId::toggle_orthographic:
            view.camera = with_other_projection(view.camera);
            return;
        case CommandId::split_view:
            return view.toggle(PaneLayout::split, scene);
        case CommandId::four_views:
            return view.toggle(PaneLayout::four, scene);
        case CommandId::look_at_selection:
            return viewport_.look_at(*place_of(scene, selection_.primary()));
        case CommandId::save_view: {
            Scene wished = scene;
            View kept = view_of(view.camera, "View " + std::to_string(scene.views.size() + 1));
            kept.id = wished.new_id();
            wished.views.push_back(std::move(kept));
            document_.commit(std::move(wished), "Keep view");
            return;
        }
        case CommandId::part_total:
            return view.show(LightPart::total, scene);
        case CommandId::part_direct:
            return view.show(LightPart::direct, scene);
        case CommandId::part_interreflected:
            return view.show(LightPart::interreflected, scene);
        case CommandId::part_unshadowed:
            return view.show(LightPart::unshadowed, scene);
        case CommandId::four_up:
            return view.toggle(PaneLayout::four_parts, scene);
        case CommandId::toggle_photo:
            view.options.scale = view.options.scale == Scale::photo ? Scale::false_colour : Scale::photo;
            return;
        case CommandId::toggle_shadow_classes:
            return view.toggle_shadow_classes(scene);
        case CommandId::toggle_shadow_outlines:
            view.options.shadow_outlines = !view.options.shadow_outlines;
            return;
        case CommandId::toggle_isolux:
            view.options.isolux = !view.options.isolux;
            return;
        case CommandId::toggle_mesh:
            view.options.mesh_lines = !view.options.mesh_lines;
            return;
        case CommandId::toggle_grids:
            view.options.grids = !view.options.grids;
            return;
        case CommandId::toggle_body:
            view.photometric_body = !view.photometric_body;
            return;
        case CommandId::fit_range:
            return fit_scale();
        default:
            return;
    }
}

}  // namespace hanei
