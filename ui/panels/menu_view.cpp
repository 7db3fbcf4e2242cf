#include "engine/edit/edit.h"
#include "engine/edit/luminaire_edits.h"
#include "engine/edit/several.h"
#include "ui/panels/measure_tool.h"
#include "ui/panels/saved_views.h"
#include "ui/panels/section.h"
#include "ui/panels/walk_tool.h"
#include "ui/panels/workbench.h"

#include <array>

namespace hanei {
namespace {

using enum CommandId;

constexpr std::string_view drawings = "Look from", pictures = "Pictures", light = "Which light",
                           over = "Over the picture";

constexpr Command in(std::string_view group, Command entry) {
    entry.group = group;
    return entry;
}

constexpr Command recalling(CommandId id, std::string_view name, std::string_view label, std::string_view help,
                            char digit) {
    return {id, name, "", label, help, control(digit)};
}

constexpr std::array table{
    Command{show_overview, "view.overview", "View", "Overview", "Show all of the room from above", {Key::home}},
    in(drawings, {show_plan, "view.plan", "View", "Plan", "Look straight down, to scale", plain('P'), {Key::keypad_7}}),
    in(drawings, {show_ceiling_plan,
                  "view.ceiling_plan",
                  "View",
                  "Ceiling plan",
                  "The ceiling as a mirror on the floor shows it, over the plan and to scale",
                  {key_of('P'), false, true},
                  {Key::keypad_7, true}}),
    in(drawings, {show_front,
                  "view.front",
                  "View",
                  "Front",
                  "Look from -y through the front wall, to scale",
                  {Key::keypad_1},
                  {key_of('F'), false, true}}),
    in(drawings,
       {show_back, "view.back", "View", "Back", "Look from +y through the back wall, to scale", {Key::keypad_1, true}}),
    in(drawings,
       {show_right, "view.right", "View", "Right", "Look from +x through the right wall, to scale", {Key::keypad_3}}),
    in(drawings,
       {show_left, "view.left", "View", "Left", "Look from -x through the left wall, to scale", {Key::keypad_3, true}}),
    Command{toggle_orthographic,
            "view.orthographic",
            "View",
            "To scale",
            "Parallel projection in place of perspective, and back; what is in the middle keeps its size",
            {Key::keypad_5}},
    Command{walk_through, "view.walk", "View", "Walk",
            "Go through the room by keys and mouse, the eye 1.6 m above the floor", plain('W')},
    Command{measure_distance, "view.measure", "View", "Measure",
            "The distance of two places that are clicked, with its parts along x, y and z", plain('D')},
    Command{look_at_selection,
            "view.look",
            "View",
            "Frame the selection",
            "Show what is selected as large as can be, and turn about it",
            plain('F'),
            {Key::keypad_decimal}},
    Command{toggle_ceiling,
            "view.ceiling",
            "View",
            "Without ceiling",
            "Take the ceiling off, as of a doll's house; luminaires stay where they hang",
            plain('U'),
            {},
            true},
    Command{toggle_section_plane, "view.section", "View", "Section plane",
            "Leave out what lies before a plane; its handle moves it in the picture, Views holds its axis", plain('K')},
    Command{save_view, "view.save", "View", "Keep this view", "Add the present camera to the project's views",
            control('K')},
    recalling(recall_view_1, "view.recall_1", "Recall view 1", "Look from the view that was kept as number 1", '1'),
    recalling(recall_view_2, "view.recall_2", "Recall view 2", "Look from the view that was kept as number 2", '2'),
    recalling(recall_view_3, "view.recall_3", "Recall view 3", "Look from the view that was kept as number 3", '3'),
    recalling(recall_view_4, "view.recall_4", "Recall view 4", "Look from the view that was kept as number 4", '4'),
    recalling(recall_view_5, "view.recall_5", "Recall view 5", "Look from the view that was kept as number 5", '5'),
    recalling(recall_view_6, "view.recall_6", "Recall view 6", "Look from the view that was kept as number 6", '6'),
    recalling(recall_view_7, "view.recall_7", "Recall view 7", "Look from the view that was kept as number 7", '7'),
    recalling(recall_view_8, "view.recall_8", "Recall view 8", "Look from the view that was kept as number 8", '8'),
    recalling(recall_view_9, "view.recall_9", "Recall view 9", "Look from the view that was kept as number 9", '9'),
    in(pictures, {split_view,
                  "view.split",
                  "View",
                  "Two pictures",
                  "Two pictures side by side, each from where you like; once more: one",
                  plain('6'),
                  {},
                  true}),
    in(pictures, {four_views, "view.four_views", "View", "Plan, front, side, perspective",
                  "Four pictures as in a drawing; once more: one", plain('7')}),
    in(pictures, {four_up, "view.four_up", "View", "All four at once",
                  "The four parts of the light side by side, on one scale", plain('5')}),
    in(light, {part_total, "view.total", "View", "Total light", "Direct and interreflected light", plain('1')}),
    in(light, {part_direct, "view.direct", "View", "Direct light", "Light straight from luminaires", plain('2')}),
    in(light, {part_interreflected, "view.interreflected", "View", "Interreflected light",
               "Light by way of other surfaces", plain('3')}),
    in(light, {part_unshadowed, "view.unshadowed", "View", "Without shadows",
               "All light as if nothing stood in its way", plain('4')}),
    in(over, {toggle_shadow_outlines, "view.shadow_outlines", "View", "Shadow outlines",
              "Where the selected luminaire's shadows end (none: all luminaires'): umbra solid, penumbra dashed",
              plain('O')}),
    in(over, {toggle_isolux, "view.isolux", "View", "Isolux lines", "Lines of equal illuminance", plain('I')}),
    in(over, {toggle_mesh, "view.mesh", "View", "Patches", "Outlines of the patches", plain('M')}),
    in(over,
       {toggle_grids, "view.grids", "View", "Calculation points", "Show where illuminance is reported", plain('N')}),
    in(over, {toggle_body,
              "view.body",
              "View",
              "Photometric body",
              "The intensities of the selected luminaire as a body of wire",
              {key_of('B'), false, true}}),
    in(over, {toggle_axes,
              "view.axes",
              "View",
              "Axes",
              "Which way x, y and z run, in a corner of every picture; a click looks along one",
              {},
              {},
              true}),
    in(over, {toggle_scale_bar,
              "view.scale_bar",
              "View",
              "Scale bar",
              "How long a length of the room is, in pictures to scale",
              {}}),
    in(over, {toggle_distances,
              "view.distances",
              "View",
              "Distances to walls",
              "In plans, how far what is selected is from the walls around it",
              {}}),
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
    Command{fit_range, "view.fit_range", "View", "Fit the scale", "Fit the colour scale to the values in the room",
            plain('R')},
};

/// The number of the view that a command recalls, from 0.
std::optional<std::size_t> recalled(CommandId id) {
    if (id < recall_view_1 || id > recall_view_9) return std::nullopt;
    return static_cast<std::size_t>(id) - static_cast<std::size_t>(recall_view_1);
}

}  // namespace

std::span<const Command> view_menu() { return table; }

bool Workbench::can_view(CommandId id) const {
    if (const std::optional<std::size_t> number = recalled(id)) return *number < document_.shown()->views.size();
    switch (id) {
        case CommandId::look_at_selection:
            return bounds_of_objects(*document_.shown(), selection_.ids()).has_value();
        case CommandId::fit_range:
            return study_.solution() != nullptr;
        default:
            return true;
    }
}

void Workbench::do_view(CommandId id) {
    const Scene& scene = *document_.shown();
    ViewState& view = viewport_.state;
    if (const std::optional<std::size_t> number = recalled(id)) {
        view.go_to(camera_of(scene.views[*number]));
        return;
    }
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
            view.go_to(with_other_projection(view.camera));
            return;
        case CommandId::walk_through:
            if (is_on(id)) return viewport_.take_up(nullptr);
            return viewport_.take_up(std::make_unique<WalkTool>(view, scene));
        case CommandId::measure_distance:
            if (is_on(id)) return viewport_.take_up(nullptr);
            return viewport_.take_up(std::make_unique<MeasureTool>());
        case CommandId::toggle_axes:
            view.axes = !view.axes;
            return;
        case CommandId::toggle_scale_bar:
            view.scale_bar = !view.scale_bar;
            return;
        case CommandId::toggle_distances:
            view.distances = !view.distances;
            return;
        case CommandId::split_view:
            return view.toggle(PaneLayout::split, scene);
        case CommandId::four_views:
            return view.toggle(PaneLayout::four, scene);
        case CommandId::look_at_selection:
            return viewport_.frame(*bounds_of_objects(scene, selection_.ids()));
        case CommandId::toggle_ceiling:
            view.camera.left_out.ceiling = !view.camera.left_out.ceiling;
            return;
        case CommandId::toggle_section_plane:
            return toggle_section(view.camera, bounds_of(scene));
        case CommandId::save_view: {
            ViewEdit kept = with_kept_view(scene, view.camera);
            document_.commit(std::move(kept.scene), kept.step);
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
