#include "engine/edit/hanging.h"
#include "engine/edit/material_palette.h"
#include "engine/edit/reflectances.h"
#include "engine/edit/sub_areas.h"
#include "ui/panels/language.h"
#include "ui/panels/plan_tool.h"
#include "ui/panels/workbench.h"

#include <array>

namespace hanei {
namespace {

using enum CommandId;

constexpr std::array table{
    Command{new_room_dialog, "room.new", "Room", "New room...", "Begin a new project with a room of these sizes",
            control('N', true)},
    Command{draw_plan, "room.draw", "Room", "Draw plan", "Draw the room's plan corner by corner", {}},
    Command{choose_room,
            "room.choose",
            "Room",
            "Edit room",
            "Select the room: its faces, reflectances and plan are in the properties",
            {}},
    Command{add_door, "room.door", "Room", "Add door", "A door in the chosen wall", {}, {}, true},
    Command{add_window, "room.window", "Room", "Add window", "A window pane in the chosen wall", {}},
    Command{add_board, "room.board", "Room", "Add whiteboard", "A whiteboard on the chosen wall", {}},
    Command{
        add_material, "room.material", "Room", "New material", "A material to choose from the palette", {}, {}, true},
    Command{drop_materials,
            "room.drop_materials",
            "Room",
            "Delete unused materials",
            "Take the materials out of the project that nothing is covered with",
            {}},
};

std::string_view sub_area_of(CommandId id) {
    return id == add_door ? "door" : id == add_window ? "window" : "whiteboard";
}

}  // namespace

std::span<const Command> room_menu() { return table; }

bool Workbench::can_room(CommandId id) const {
    switch (id) {
        case choose_room:
        case add_door:
        case add_window:
        case add_board:
            return document_.shown()->room.has_value();
        default:
            return true;
    }
}

void Workbench::do_room(CommandId id) {
    const Scene& scene = *document_.shown();
    switch (id) {
        case new_room_dialog:
            return guarded([this] { furnishing_.ask_new_room(); });
        case draw_plan:
            document_.settle();
            viewport_.look_from(Standpoint::plan, *document_.shown());
            return viewport_.take_up(std::make_unique<PlanTool>(scene.room ? scene.room->floor_height : 0.0));
        case choose_room:
            return selection_.choose(scene.room->id);
        case add_door:
        case add_window:
        case add_board: {
            const SubAreaKind& kind = *find_sub_area_kind(sub_area_of(id));
            const int wall = std::clamp(furnishing_.room.face, Room::wall_face(0), face_count(*scene.room) - 1);
            Added added = with_sub_area(scene, kind, wall);
            if (!added.object) {
                message_ = "The chosen wall is too small for it";
                return;
            }
            return add(std::move(added), ("Add " + std::string(kind.label)).c_str());
        }
        case add_material: {
            Scene wished = scene;
            Material material;
            material.id = wished.new_id();
            material.name = free_name(scene, "Material 1");
            const ObjectId made = material.id;
            wished.materials.push_back(std::move(material));
            return add(Added{std::move(wished), made}, "Add material");
        }
        case drop_materials: {
            Scene wished = without_unused_materials(scene);
            const std::size_t gone = scene.materials.size() - wished.materials.size();
            message_ = gone == 0 ? tr("Every material is in use") : say("{} unused materials deleted", gone);
            if (gone > 0) document_.commit(std::move(wished), "Delete unused materials");
            selection_.keep_existing(*document_.shown());
            return;
        }
        default:
            return;
    }
}

void Workbench::furnishing_wish(Furnishing::Wish wish) {
    if (wish.tool) viewport_.take_up(std::move(wish.tool));
    if (wish.abandons) document_.abandon();
    if (!wish.begins_from.empty()) return begin_from(wish.begins_from);
    if (!wish.scene) return;
    if (wish.begins_anew) return begin_anew(std::move(*wish.scene));
    if (wish.previews) return document_.propose(std::move(*wish.scene), std::move(wish.step));
    document_.abandon();  // of a preview: the same in full
    document_.commit(std::move(*wish.scene), std::move(wish.step));
    choose(wish.chosen);
}

void Workbench::begin_anew(Scene scene) {
    show(Document({std::move(scene), document_.settings()}));
    viewport_.take_up(nullptr);
    furnishing_.room = {};
    message_ = "New room";
}

}  // namespace hanei
