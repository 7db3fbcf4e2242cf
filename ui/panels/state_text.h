/// The state of the window as JSON: what scripts and test drivers wait for and compare.
#pragma once

#include "ui/panels/workbench.h"

#include <map>
#include <string>

namespace hanei {

/// Flat: one name, one figure or word. "frame", "settled", "undo depth", "selected", "selected.x",
/// "solves ms", "probe", "grid NAME mean", "point NAME", ...
std::map<std::string, std::string> state_of(const Workbench& workbench);

/// The same as one JSON object, with "widgets": name -> [left, top, right, bottom] and "objects":
/// name -> [x, y] on the screen.
std::string state_json(const Workbench& workbench);

}  // namespace hanei
