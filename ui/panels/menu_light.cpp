#include "engine/edit/arrangements.h"
#include "engine/edit/control_groups.h"
#include "engine/edit/mounting.h"
#include "ui/panels/aim_tool.h"
#include "ui/panels/workbench.h"

#include <array>
#include <fmt/format.h>

namespace hanei {
namespace {

using enum CommandId;

constexpr Chord scene_key(int number) { return {function_key(number), true}; }

constexpr Command recall(CommandId id, std::string_view name, std::string_view label, int number) {
    return {id, name, "", label, "Sets the dimmers as the light scene of this number stores them", scene_key(number)};
}

constexpr std::array table{
    Command{light_line,
            "light.line",
            "Light",
            "Line of luminaires...",
            "Luminaires like the selected one in a line; of a file when none is selected",
            {}},
    Command{light_field,
            "light.field",
            "Light",
            "Field of luminaires...",
            "Rows and columns over the room, half a spacing from its walls",
            {}},
    Command{light_circle, "light.circle", "Light", "Circle of luminaires...", "Luminaires at equal angles", {}},
    Command{light_layout,
            "light.layout",
            "Light",
            "Start layout for an illuminance...",
            "As many luminaires as the lumen method needs for the lux that are wanted",
            {}},
    Command{light_aim,
            "light.aim",
            "Light",
            "Aim at a point",
            "Turn the selected luminaires at a place in the view",
            plain('A'),
            {},
            true},
    Command{light_recessed, "light.recessed", "Light", "Recess in the ceiling", "Flush with the ceiling", {}, {}, true},
    Command{light_surface, "light.surface", "Light", "Mount on the ceiling", "Below it by the height of a housing", {}},
    Command{light_pendant, "light.pendant", "Light", "Suspend", "By 0.5 m from the ceiling", {}},
    Command{light_wall, "light.wall", "Light", "Mount on the wall", "On the nearest wall, 2 m up, facing the room", {}},
    Command{light_standing, "light.standing", "Light", "Stand on the floor", "At 1.8 m above the floor", {}},
    Command{light_group,
            "light.group",
            "Light",
            "New control group",
            "The selected luminaires are dimmed together",
            {},
            {},
            true},
    Command{light_keep, "light.keep_scene", "Light", "Keep light scene", "All dimmers as they are, to be recalled", {}},
    recall(light_scene_1, "light.scene_1", "Light scene 1", 1),
    recall(light_scene_2, "light.scene_2", "Light scene 2", 2),
    recall(light_scene_3, "light.scene_3", "Light scene 3", 3),
    recall(light_scene_4, "light.scene_4", "Light scene 4", 4),
    recall(light_scene_5, "light.scene_5", "Light scene 5", 5),
    recall(light_scene_6, "light.scene_6", "Light scene 6", 6),
    recall(light_scene_7, "light.scene_7", "Light scene 7", 7),
    recall(light_scene_8, "light.scene_8", "Light scene 8", 8),
    recall(light_scene_9, "light.scene_9", "Light scene 9", 9),
};

std::size_t number_of(CommandId id) { return static_cast<std::size_t>(id) - static_cast<std::size_t>(light_scene_1); }

MountingWish wish_of(CommandId id) {
    MountingWish wish{mountings[static_cast<std::size_t>(id) - static_cast<std::size_t>(light_recessed)]};
    constexpr double usual_on_walls = 2.0;  // m
    if (wish.mounting == Mounting::wall) wish.height = usual_on_walls;
    return wish;
}

}  // namespace

std::span<const Command> light_menu() { return table; }

bool Workbench::can_light(CommandId id) const {
    const Scene& scene = *document_.shown();
    switch (id) {
        case light_line:
        case light_field:
        case light_circle:
        case light_layout:
            return true;
        case light_aim:
        case light_group:
            return !luminaires_among(scene, selection_.ids()).empty();
        case light_recessed:
        case light_surface:
        case light_pendant:
        case light_wall:
        case light_standing:
            return scene.room && !luminaires_among(scene, selection_.ids()).empty();
        case light_keep:
            return !scene.control_groups.empty();
        default:
            return number_of(id) < scene.light_scenes.size();
    }
}

void Workbench::do_light(CommandId id) {
    const Scene& scene = *document_.shown();
    const std::vector<ObjectId> luminaires = luminaires_among(scene, selection_.ids());
    switch (id) {
        case light_line:
        case light_field:
        case light_circle:
            return lay_out_luminaires(id);
        case light_layout:
            if (scene.luminaires.empty()) return lay_out_luminaires(id);
            return start_layout_.open(luminaires.empty() ? scene.luminaires.front().id : luminaires.front());
        case light_aim:
            return viewport_.take_up(std::make_unique<AimTool>(luminaires));
        case light_recessed:
        case light_surface:
        case light_pendant:
        case light_wall:
        case light_standing:
            return document_.commit(mounted(scene, luminaires, wish_of(id)),
                                    luminaires.size() == 1 ? "Mount luminaire" : "Mount luminaires");
        case light_group: {
            Added added = with_control_group(scene, luminaires);
            return document_.commit(std::move(added.scene), "New control group");
        }
        case light_keep:
            return document_.commit(with_light_scene(scene).scene, "Keep light scene");
        default: {
            const LightScene light_scene = scene.light_scenes[number_of(id)];
            document_.commit(recalled(scene, light_scene.id), recall_step(light_scene));
            message_ = light_scene.name;
        }
    }
}

}  // namespace hanei
