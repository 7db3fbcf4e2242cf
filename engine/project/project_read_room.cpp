#include "engine/project/project_reader.h"

#include <charconv>

namespace hanei {
namespace {

/// "floor", "ceiling" or "wall 3".
void take_face(Fields& fields, int& face) {
    std::string text;
    if (!fields.require("face", text, "\"floor\", \"ceiling\" or \"wall 0\", \"wall 1\", ...")) return;
    constexpr std::string_view wall = "wall ";
    int number = -1;
    if (text == "floor") {
        face = Room::floor_face;
    } else if (text == "ceiling") {
        face = Room::ceiling_face;
    } else if (text.starts_with(wall) &&
               std::from_chars(text.data() + wall.size(), text.data() + text.size(), number).ptr ==
                   text.data() + text.size() &&
               number >= 0 && number <= 1'000'000) {
        face = Room::wall_face(number);
    } else {
        fields.error("face", "found " + described(*fields.value().find("face")) +
                                 ", expected \"floor\", \"ceiling\" or \"wall 0\", \"wall 1\", ...");
    }
}

SubArea sub_area_of(SceneReader& reader, Fields& fields) {
    SubArea area;
    area.id = reader.take_id(fields);
    fields.optional("name", area.name);
    take_face(fields, area.face);
    fields.require("low", area.low, "the corner [x, y] nearest to the face's origin");
    fields.require("high", area.high, "the corner [x, y] opposite to \"low\"");
    area.material = take_material(reader, fields, "material");
    area.unknown = fields.unknown();
    return area;
}

/// A list of one material a wall, or one material for all walls.
std::vector<ObjectId> take_walls(SceneReader& reader, Fields& fields, std::size_t walls) {
    const JsonValue* const value = fields.take("walls");
    if (value == nullptr) {
        fields.missing("walls", "one material a wall, or one for all");
        return std::vector<ObjectId>(walls);
    }
    if (!value->is(JsonValue::Kind::list))
        return std::vector<ObjectId>(walls, material_of(reader, *value, fields.path_of("walls")));
    std::vector<ObjectId> materials;
    for (std::size_t k = 0; k < value->items.size(); ++k)
        materials.push_back(
            material_of(reader, value->items[k], fields.path_of("walls") + '[' + std::to_string(k) + ']'));
    return materials;
}

}  // namespace

void read_materials(SceneReader& reader, Fields& root) {
    for_each_object(root, "materials", [&](Fields& fields, std::size_t) {
        Material material;
        material.id = reader.take_id(fields);
        fields.require("name", material.name, "a text");
        fields.require("reflectance", material.reflectance, "a number from 0 to 1");
        fields.optional("tint", material.tint);
        material.unknown = fields.unknown();
        reader.scene.materials.push_back(std::move(material));
    });
}

void read_room(SceneReader& reader, Fields& root) {
    const JsonValue* const value = root.take("room");
    if (value == nullptr) return;
    Fields fields(reader.reading, *value, "room");
    Room room;
    room.id = reader.take_id(fields);
    fields.optional("name", room.name);
    fields.require("plan", room.plan, "the corners [x, y] of the floor, counter-clockwise");
    fields.optional("floor_height", room.floor_height);
    fields.require("height", room.height, "the clear height in metres");
    room.floor_material = take_material(reader, fields, "floor");
    room.ceiling_material = take_material(reader, fields, "ceiling");
    room.wall_materials = take_walls(reader, fields, room.plan.size());
    for_each_object(fields, "sub_areas",
                    [&](Fields& area, std::size_t) { room.sub_areas.push_back(sub_area_of(reader, area)); });
    room.unknown = fields.unknown();
    reader.scene.room = std::move(room);
}

}  // namespace hanei
