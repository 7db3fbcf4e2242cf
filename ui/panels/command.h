/// Everything the user can ask for by menu or key: one table for menus, keys, help and tests.
#pragma once

#include "ui/panels/key.h"

#include <span>
#include <string_view>

namespace hanei {

enum class CommandId {
    new_project,
    open,
    save,
    save_as,
    recover_work,
    start_page,
    import_model,
    export_model,
    export_picture,
    export_values,
    copy_picture,
    toggle_recording,
    render_exact,
    quit,
    edit_preferences,
    undo,
    redo,
    show_history,
    cut,
    copy,
    paste,
    duplicate,
    remove,
    select_all,
    select_same,
    box_select,
    deselect,
    toggle_snap,
    snap_settings,
    nudge_left,
    nudge_right,
    nudge_down,
    nudge_up,
    nudge_lower,
    nudge_higher,
    turn_object,
    turn_intensities,
    add_point_luminaire,
    add_line_luminaire,
    add_panel_luminaire,
    add_luminaire_file,
    add_box,
    add_furniture,
    new_room_dialog,
    draw_plan,
    choose_room,
    add_door,
    add_window,
    add_board,
    add_material,
    drop_materials,
    array_copies,
    circle_copies,
    mirror_left_right,
    mirror_up_down,
    mirror_over_x,
    mirror_over_y,
    align_left,
    align_middle_x,
    align_right,
    align_top,
    align_middle_y,
    align_bottom,
    spread_x,
    spread_y,
    put_on_floor,
    push_to_wall,
    turn_to_wall,
    group_objects,
    ungroup_objects,
    add_grid,
    add_calculation_point,
    light_line,
    light_field,
    light_circle,
    light_layout,
    light_aim,
    light_recessed,
    light_surface,
    light_pendant,
    light_wall,
    light_standing,
    light_group,
    light_keep,
    light_scene_1,
    light_scene_2,
    light_scene_3,
    light_scene_4,
    light_scene_5,
    light_scene_6,
    light_scene_7,
    light_scene_8,
    light_scene_9,
    show_overview,
    show_plan,
    show_ceiling_plan,
    show_front,
    show_back,
    show_left,
    show_right,
    toggle_orthographic,
    walk_through,
    measure_distance,
    look_at_selection,
    toggle_ceiling,
    toggle_section_plane,
    save_view,
    recall_view_1,
    recall_view_2,
    recall_view_3,
    recall_view_4,
    recall_view_5,
    recall_view_6,
    recall_view_7,
    recall_view_8,
    recall_view_9,
    split_view,
    four_views,
    part_total,
    part_direct,
    part_interreflected,
    part_unshadowed,
    four_up,
    toggle_photo,
    toggle_shadow_classes,
    toggle_shadow_outlines,
    toggle_isolux,
    toggle_mesh,
    toggle_grids,
    toggle_body,
    toggle_axes,
    toggle_scale_bar,
    toggle_distances,
    fit_range,
    switch_theme,
    switch_language,
    larger,
    smaller,
    usual_size,
    toggle_values,
    pin_here,
    explain,
    keep_a,
    keep_b,
    show_a,
    show_difference,
    draw_profile,
    show_histogram,
    compare_measured,
    study_accuracy,
    check_scene,
    check_answer,
    command_search,
    show_keys,
    show_validation,
    show_about,
};

struct Command {
    CommandId id;
    std::string_view name;  ///< "edit.undo": what scripts and tests call it
    std::string_view menu;  ///< menu it stands in; empty: reached by key alone
    std::string_view label;
    std::string_view help;  ///< one sentence: tooltip and keyboard map
    Chord chord;
    Chord other = {};  ///< a second chord for the same thing
    bool starts_section = false;
    std::string_view group = {};  ///< the menu within the menu that it stands in
};

// The rows of each menu stand with what they do, in menu_NAME.cpp.
std::span<const Command> file_menu();
std::span<const Command> edit_menu();
std::span<const Command> add_menu();
std::span<const Command> room_menu();
std::span<const Command> arrange_menu();
std::span<const Command> light_menu();
std::span<const Command> view_menu();
std::span<const Command> look_menu();  ///< the end of the View menu
std::span<const Command> results_menu();
std::span<const Command> help_menu();

/// In the order of the menus.
std::span<const Command> commands();
const Command& command(CommandId id);

/// Null when no command has this chord.
const Command* command_for(const Chord& chord);

}  // namespace hanei
