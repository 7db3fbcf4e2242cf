/// Small drawings that say what a thing is by their shape, so that no colour has to.
///
/// Lines on a sheet of 24 by 24, drawn at any size with strokes of one thickness: no font, no picture
/// file. A new one is a line in icon_shapes.cpp.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/edit/edit.h"
#include "ui/panels/command.h"
#include "ui/panels/widget_registry.h"

#include <imgui.h>
#include <string_view>

namespace hanei {

enum class Icon {
    none,
    // Things of a room.
    luminaire,
    furniture,
    room,
    surface,
    grid,
    point,
    material,
    view,
    group,
    light_scene,
    dimmer,
    opening,
    // How it stands.
    done,
    busy,
    stale,
    stopped,
    note,
    warning,
    error,
    // Things to do.
    pointer,
    move,
    turn,
    aim,
    box,
    plan,
    profile,
    pin,
    walk,
    section,
    measure,
    isolux,
    shadows,
    patches,
    photo,
    false_colours,
    overview,
    four,
    compare,
    fit,
    search,
    add,
    remove,
    duplicate,
    undo,
    redo,
    open,
    save,
    picture,
    file,
    folder,
    visible,
    hidden,
    locked,
    close,
    settings,
    theme,
    language,
    distance,
    sum,
};
inline constexpr int icon_count = static_cast<int>(Icon::sum) + 1;

/// Draws into a square of `size` pixels whose upper left corner is given. Mirrored never; crisp at
/// every scale, since lines are at least one pixel thick.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 corner, float size, ImU32 colour);

/// As high as a line of text, in that line; followed by what stands next in it.
void icon_item(Icon icon, ImU32 colour);
float icon_size();

/// A square button with a tooltip. `on`: it is one that stays down, and is. `name` is what scripts call it.
bool icon_button(const char* name, Icon icon, const std::string& help, bool on, WidgetRegistry& widgets);

/// A button with a drawing before its word.
bool icon_text_button(const char* label, Icon icon);

Icon icon_of(ObjectKind kind);
Icon icon_of(Severity severity);
ImU32 colour_of(Severity severity);  ///< besides

/// A command and its drawing; whoever adds a command with a button adds it in icon.cpp.
struct CommandIcon {
    std::string_view command;
    Icon icon;
};
std::span<const CommandIcon> command_icons();

/// None for a command without one.
Icon icon_of(std::string_view command_name);

/// The drawing's lines in the language of icon_shapes.cpp.
std::string_view shape_of(Icon icon);

}  // namespace hanei
