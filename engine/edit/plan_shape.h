/// Questions about a room's plan: a simple polygon, counter-clockwise seen from above.
#pragma once

#include "engine/base/vector.h"

#include <string>
#include <vector>

namespace hanei {

bool plan_holds(const std::vector<Vec2>& plan, const Vec2& place);
/// The whole rectangle.
bool plan_holds(const std::vector<Vec2>& plan, const Vec2& low, const Vec2& high);

/// Middle of the plan's area.
Vec2 middle_of_plan(const std::vector<Vec2>& plan);

/// Why these corners make no room, in one sentence; empty when they do. The order they run in is no fault.
std::string fault_of_plan(const std::vector<Vec2>& corners);

/// The same corners counter-clockwise, without those that lie on a straight wall or stand twice.
std::vector<Vec2> tidy_plan(std::vector<Vec2> corners);

/// Whether the last edge of an open line crosses or touches another, but for its neighbour's end.
bool last_edge_crosses(const std::vector<Vec2>& line);

/// Plans to begin with, their lowest corner at the origin: "box", "L", "T", "U".
///
/// Returns   no corners for another name.
std::vector<Vec2> usual_plan(std::string_view shape, double length, double width);

/// "0,0 6,0 6,4 0,4": pairs of metres with blanks between.
///
/// Returns   no corners when the text is none.
std::vector<Vec2> plan_of_text(const std::string& text);

}  // namespace hanei
