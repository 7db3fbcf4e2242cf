/// The dimmers of the room: control groups with a slider each, and light scenes to recall.
#pragma once

#include "engine/edit/control_groups.h"
#include "ui/panels/selection.h"
#include "ui/panels/widget_registry.h"

#include <map>
#include <optional>
#include <string>

namespace hanei {

class LightPanel {
public:
    struct Outcome {
        std::optional<Scene> scene;      ///< the scene the user would rather have
        std::string step;                ///< its name in the history
        bool at_once = true;             ///< a step of its own; else a gesture until its widget is let go
        std::optional<ObjectId> chosen;  ///< shown by the other panels
    };

    /// Draws into the rest of the present ImGui window.
    Outcome draw(const Scene& scene, const Selection& selection, WidgetRegistry& widgets);

    /// Off, or on again as it was before; alone, or all again as they were before.
    Outcome switched(const Scene& scene, const ControlGroup& group);
    Outcome soloed(const Scene& scene, const ControlGroup& group);

private:
    void scenes(const Scene& scene, WidgetRegistry& widgets, Outcome& outcome);
    void scene_menu(const Scene& scene, const LightScene& light_scene, WidgetRegistry& widgets, Outcome& outcome);
    void group(const Scene& scene, const ControlGroup& group, const std::vector<ObjectId>& luminaires,
               const Selection& selection, WidgetRegistry& widgets, Outcome& outcome);
    void dimmer(const Scene& scene, const ControlGroup& group, WidgetRegistry& widgets, Outcome& outcome);

    std::map<ObjectId, double> level_before_off_;
    struct Solo {
        ObjectId group;
        std::vector<LightScene::Level> before;
    };
    std::optional<Solo> solo_;
    std::string new_name_;  ///< while a light scene is renamed
};

/// The step of recalling it: "Switch to Lecture".
std::string recall_step(const LightScene& light_scene);

/// The group is on and every other is off.
bool is_alone(const Scene& scene, ObjectId group);

}  // namespace hanei
