/// The strip of buttons beside the view: what is asked for most, one click away.
///
/// A button is a command with a drawing; its tooltip gives name, help and key. What finds no room in a
/// low window is reached by menu and key.
#pragma once

#include "ui/panels/command.h"

#include <span>

namespace hanei {

/// Pixels at the present scale.
float tool_bar_width();

/// Names of commands, from the top; an empty one is a gap.
std::span<const std::string_view> tool_bar_entries();

}  // namespace hanei
