/// The room's properties: its faces and what they are covered with, its plan, doors and windows.
#pragma once

#include "engine/scene/scene.h"
#include "ui/panels/form.h"

#include <optional>
#include <string>

namespace hanei {

/// What of the room is looked at: kept by the window.
struct RoomFocus {
    int face = Room::wall_face(0);  ///< chosen in the view or in the panel
    std::string message;            ///< why the last wish was refused, or what went with it
    ObjectId made;                  ///< a sub-area added in this frame
    bool draws_plan = false;        ///< the plan is to be drawn anew
};

/// Needs     an open form.
std::optional<Scene> room_panel(const Scene& scene, RoomFocus& focus, Form& form);

}  // namespace hanei
