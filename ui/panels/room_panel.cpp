#include "ui/panels/room_panel.h"

#include "engine/edit/plan_edits.h"
#include "engine/edit/sub_areas.h"
#include "ui/panels/button_row.h"
#include "ui/panels/properties.h"
#include "ui/panels/property_rows.h"

#include <algorithm>
#include <fmt/format.h>

namespace hanei {
namespace {

bool shape_rows(Room& room, Form& form) {
    bool changed = form.text("room.name", "Name", "What this room is called", room.name);
    changed |= form.number({"room.height", "Height", "m", "Clear height from floor to ceiling", 0.1, 1000.0, 0.01, 3},
                           room.height);
    changed |=
        form.number({"room.floor", "Floor at", "m", "Height of the floor", -1e4, 1e4, 0.01, 3}, room.floor_height);
    return changed;
}

/// Lowered ceilings take what hangs on the walls along.
void fit_sub_areas(Room& room) {
    std::erase_if(room.sub_areas, [&](SubArea& area) { return !fit_into_face(area, room); });
}

std::optional<Scene> preset_row(const Scene& scene, Form& form) {
    std::vector<ButtonText> buttons;
    for (const ReflectancePreset& preset : reflectance_presets())
        buttons.push_back(
            {fmt::format("room.preset.{}", preset.name), std::string(preset.name), std::string(preset.help)});
    const int pressed = button_row("Presets", buttons, form);
    if (pressed < 0) return std::nullopt;
    return with_reflectances(scene, reflectance_presets()[static_cast<std::size_t>(pressed)].values);
}

bool material_rows(const Scene& scene, Room& room, Form& form) {
    bool changed = material_row("room.ceiling", "Ceiling", scene, room.ceiling_material, form);
    const bool alike = std::all_of(room.wall_materials.begin(), room.wall_materials.end(),
                                   [&](ObjectId wall) { return wall == room.wall_materials.front(); });
    ObjectId walls = alike && !room.wall_materials.empty() ? room.wall_materials.front() : ObjectId{};
    if (material_row("room.walls", "All walls", scene, walls, form)) {
        std::fill(room.wall_materials.begin(), room.wall_materials.end(), walls);
        changed = true;
    }
    changed |= material_row("room.floor_material", "Floor", scene, room.floor_material, form);
    return changed;
}

void face_choice(const Room& room, RoomFocus& focus, Form& form) {
    std::vector<std::string> names;
    for (int face = 0; face < face_count(room); ++face) {
        const bool wall = face >= Room::wall_face(0);
        names.push_back(wall ? fmt::format("{}  {:.2f} m", name_of_face(face),
                                           wall_length(room, static_cast<std::size_t>(face - Room::wall_face(0))))
                             : name_of_face(face));
    }
    form.choice("room.face", "Face",
                "The face that the rows below are about; a click on it in the view chooses it, too", names, focus.face);
}

/// What can be put on the chosen face.
std::optional<Scene> add_rows(const Scene& scene, RoomFocus& focus, Form& form) {
    std::vector<ButtonText> buttons;
    std::vector<const SubAreaKind*> kinds;
    for (const SubAreaKind& kind : sub_area_kinds()) {
        if (kind.level != (focus.face < Room::wall_face(0))) continue;
        kinds.push_back(&kind);
        buttons.push_back({fmt::format("room.add.{}", kind.kind), std::string(kind.label), std::string(kind.help)});
    }
    const int pressed = button_row("Add", buttons, form);
    if (pressed < 0) return std::nullopt;
    Added added = with_sub_area(scene, *kinds[static_cast<std::size_t>(pressed)], focus.face);
    if (!added.object) {
        focus.message = "This face is too small for it.";
        return std::nullopt;
    }
    focus.made = added.object;
    return std::move(added.scene);
}

std::optional<Scene> taken(PlanEdit edit, RoomFocus& focus) {
    focus.message = std::move(edit.message);
    return std::move(edit.scene);
}

std::optional<Scene> wall_rows(const Scene& scene, RoomFocus& focus, Form& form) {
    const Room& room = *scene.room;
    const auto wall = static_cast<std::size_t>(focus.face - Room::wall_face(0));
    double length = wall_length(room, wall);
    if (form.number(
            {"room.wall.length", "Length", "m", "Moves the wall's end, and the next wall with it", 0.01, 1e4, 0.01, 3},
            length))
        return taken(with_wall_length(scene, wall, length), focus);
    const ButtonText buttons[] = {
        {"room.wall.split", "Insert corner", "Cuts this wall in two at its middle; drag the corner in the plan"},
        {"room.wall.join", "Remove corner", "Takes away the corner that this wall begins with"}};
    const int pressed = button_row("", buttons, form);
    const Vec2 middle = 0.5 * (room.plan[wall] + room.plan[(wall + 1) % room.plan.size()]);
    if (pressed == 0) return taken(with_corner_inserted(scene, wall, middle), focus);
    if (pressed == 1) return taken(with_corner_removed(scene, wall), focus);
    return std::nullopt;
}

std::optional<Scene> plan_rows(const Scene& scene, RoomFocus& focus, Form& form) {
    const std::vector<Vec2>& plan = scene.room->plan;
    for (std::size_t k = 0; k < plan.size(); ++k) {
        Vec2 corner = plan[k];
        const std::string x = fmt::format("room.plan{}.x", k + 1);
        const std::string y = fmt::format("room.plan{}.y", k + 1);
        const std::string label_x = fmt::format("Corner {}  x", k + 1);
        bool changed =
            form.number({x.c_str(), label_x.c_str(), "m", "Corner of the plan", -1e4, 1e4, 0.01, 3}, corner.x);
        changed |= form.number({y.c_str(), "y", "m", "Corner of the plan", -1e4, 1e4, 0.01, 3}, corner.y);
        if (changed) return taken(with_corner_moved(scene, k, corner), focus);
    }
    focus.draws_plan = form.button("room.draw_plan", "Draw the plan anew", "Corner by corner, in the plan view");
    return std::nullopt;
}

}  // namespace

std::optional<Scene> room_panel(const Scene& scene, RoomFocus& focus, Form& form) {
    focus.made = {};
    focus.draws_plan = false;
    if (!scene.room) return std::nullopt;
    focus.face = std::clamp(focus.face, 0, std::max(0, face_count(*scene.room) - 1));
    std::optional<Scene> wished;
    Room room = *scene.room;
    bool changed = shape_rows(room, form);
    form.heading("Reflectances");
    std::optional<Scene> preset = preset_row(scene, form);
    changed |= material_rows(scene, room, form);
    form.heading("Face");
    face_choice(room, focus, form);
    form.fact("Area", fmt::format("{:.2f}", area_of_face(room, focus.face)), "m²");
    changed |= material_row("room.face.material", "Material", scene, material_of_face(room, focus.face), form);
    if (focus.face >= Room::wall_face(0)) wished = wall_rows(scene, focus, form);
    if (std::optional<Scene> added = add_rows(scene, focus, form)) wished = std::move(added);
    if (!focus.message.empty()) form.remark(focus.message, true);
    form.heading("Plan");
    if (std::optional<Scene> planned = plan_rows(scene, focus, form)) wished = std::move(planned);
    if (preset) wished = std::move(preset);
    if (!changed) return wished;
    fit_sub_areas(room);
    Scene with_room = scene;
    with_room.room = std::move(room);
    return with_room;
}

std::optional<Scene> sub_area_panel(const Scene& scene, ObjectId id, Form& form) {
    const SubArea* const present = find_sub_area(scene, id);
    if (present == nullptr) return std::nullopt;
    SubArea area = *present;
    bool changed = form.text("area.name", "Name", "What this door, window or board is called", area.name);
    std::vector<std::string> faces;
    for (int face = 0; face < face_count(*scene.room); ++face) faces.push_back(name_of_face(face));
    changed |= form.choice("area.face", "Face", "The face of the room that it lies on", faces, area.face);
    changed |= material_row("area.material", "Material", scene, area.material, form);
    form.heading("Size");
    Vec2 size = area.high - area.low;
    bool sized = form.number({"area.width", "Width", "m", "Along the wall", 0.05, 1e4, 0.01, 3}, size.x);
    sized |= form.number({"area.height", "Height", "m", "Over all", 0.05, 1e4, 0.01, 3}, size.y);
    form.heading("Place");
    const bool level = area.face < Room::wall_face(0);
    Vec2 low = area.low;
    sized |= form.number({"area.x", level ? "x" : "Along wall", "m", "From the wall's first corner to its near edge",
                          -1e4, 1e4, 0.01, 3},
                         low.x);
    sized |= form.number(
        {"area.sill", level ? "y" : "Sill", "m", "From the floor to its lower edge", -1e4, 1e4, 0.01, 3}, low.y);
    if (sized) {
        area.low = low;
        area.high = low + size;
    }
    if (!(changed || sized) || !fit_into_face(area, *scene.room)) return std::nullopt;
    Scene wished = scene;
    for (SubArea& each : wished.room->sub_areas)
        if (each.id == id) each = area;
    return wished;
}

}  // namespace hanei
