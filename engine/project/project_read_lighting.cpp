#include "engine/project/project_reader.h"

namespace hanei {
namespace {

Layout layout_of(Fields& fields) {
    constexpr const char* vector = "three numbers [x, y, z]";
    constexpr const char* number = "a whole number, 1 or more";
    std::string kind = "line";
    fields.require("kind", kind, "\"line\", \"field\" or \"circle\"");
    if (kind == "line") {
        LineLayout line;
        fields.require("from", line.from, vector);
        fields.require("to", line.to, vector);
        fields.require("count", line.count, number);
        return line;
    }
    if (kind == "field") {
        FieldLayout field;
        fields.require("corner", field.corner, vector);
        fields.require("along", field.along, vector);
        fields.require("across", field.across, vector);
        fields.require("columns", field.columns, number);
        fields.require("rows", field.rows, number);
        return field;
    }
    CircleLayout circle;
    if (kind == "circle") {
        fields.require("middle", circle.middle, vector);
        fields.require("radius", circle.radius, "a number, 0 or more");
        fields.require("count", circle.count, number);
        fields.optional_angle("first_angle_deg", circle.first_angle);
        fields.optional("face_outward", circle.face_outward);
    } else {
        fields.error("kind", "found " + json_quoted(kind) + ", expected \"line\", \"field\" or \"circle\"");
    }
    return circle;
}

/// References to luminaires, null where a place is empty.
std::vector<ObjectId> luminaires_of(SceneReader& reader, Fields& fields) {
    std::vector<ObjectId> luminaires;
    const JsonValue* const list = fields.take("luminaires");
    if (list == nullptr) fields.missing("luminaires", "the names of luminaires, one a place");
    if (list == nullptr || !take_list(reader.reading, *list, fields.path_of("luminaires"))) return luminaires;
    for (std::size_t i = 0; i < list->items.size(); ++i) {
        const JsonValue& value = list->items[i];
        const std::string path = fields.path_of("luminaires") + '[' + std::to_string(i) + ']';
        luminaires.push_back(value.is(JsonValue::Kind::null) ? ObjectId{} : luminaire_of(reader, value, path));
    }
    return luminaires;
}

}  // namespace

void read_light_scenes(SceneReader& reader, Fields& root) {
    for_each_object(root, "light_scenes", [&](Fields& fields, std::size_t) {
        LightScene light_scene;
        light_scene.id = reader.take_id(fields);
        fields.optional("name", light_scene.name);
        for_each_object(fields, "levels", [&](Fields& level, std::size_t) {
            LightScene::Level& made = light_scene.levels.emplace_back();
            made.group = take_known_control_group(reader, level, "group");
            level.require("dimming", made.dimming, "a number from 0 to 1");
            level.drop_unknown();
        });
        light_scene.unknown = fields.unknown();
        reader.scene.light_scenes.push_back(std::move(light_scene));
    });
}

void read_arrangements(SceneReader& reader, Fields& root) {
    for_each_object(root, "arrangements", [&](Fields& fields, std::size_t) {
        Arrangement arrangement;
        JsonValue kept = json_object();
        arrangement.id = reader.take_id(fields);
        fields.optional("name", arrangement.name);
        if (const JsonValue* const value = fields.take("layout")) {
            Fields layout(reader.reading, *value, fields.path_of("layout"));
            arrangement.layout = layout_of(layout);
            keep_unknown(layout, "layout", kept);
        } else {
            fields.missing("layout", "{\"kind\": \"line\"} or another kind");
        }
        fields.optional_angle("yaw_deg", arrangement.yaw);
        arrangement.luminaires = luminaires_of(reader, fields);
        arrangement.unknown = unknown_of(fields, std::move(kept));
        reader.scene.arrangements.push_back(std::move(arrangement));
    });
}

void read_control_groups(SceneReader& reader, Fields& root) {
    for_each_object(root, "control_groups", [&](Fields& fields, std::size_t) {
        ControlGroup group;
        group.id = reader.take_id(fields);
        fields.optional("name", group.name);
        fields.optional("dimming", group.dimming);
        fields.optional("colour_temperature_k", group.colour_temperature);
        group.unknown = fields.unknown();
        reader.scene.control_groups.push_back(std::move(group));
    });
}

}  // namespace hanei
