/// What a click or a box in the view, or a row of the tree, makes of the selection.
///
/// A member of a group stands for its group, until the group is entered: by a double click, by Alt, or
/// because a member of it is chosen alone already.
#pragma once

#include "engine/edit/several.h"
#include "ui/panels/pane.h"
#include "ui/panels/selection.h"

namespace hanei {

struct ClickManner {
    bool toggles = false;  ///< Shift or Ctrl: joins what is chosen, or leaves it
    bool alone = false;    ///< Alt: the member, not its group
    bool twice = false;    ///< a double click enters a group, and takes all of an arrangement
};

/// What a click on this object means: itself, its group or its arrangement.
ObjectId meant_by_click(const Scene& scene, const Selection& before, ObjectId hit, ClickManner manner);

/// A click beside everything (a `hit` of nothing) lets go of all, unless it toggles.
Selection chosen_by_click(const Scene& scene, const Selection& before, ObjectId hit, ClickManner manner);

enum class BoxManner { replaces, adds, takes };
Selection chosen_by_box(const Scene& scene, const Selection& before, const ObjectIds& boxed, BoxManner manner);

/// The objects in a box of the screen, as in CAD: drawn from left to right those that lie wholly in
/// it, from right to left those that it touches as well. What others hide counts too.
///
/// Needs     points and grids are only among them when they are shown.
/// Cost      linear in the vertices of the scene.
ObjectIds objects_in_box(const Scene& scene, const Pane& pane, ImVec2 from, ImVec2 to, bool with_points);

/// Rows of a list between two of them, both included, in the list's order.
ObjectIds rows_between(const ObjectIds& rows, ObjectId first, ObjectId last);

}  // namespace hanei
