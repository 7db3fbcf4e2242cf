#include "engine/project/project_writer.h"

namespace hanei {
namespace {

struct LayoutWriter {
    JsonValue& object;

    void operator()(const LineLayout& line) {
        object.add("kind", json_text("line"));
        object.add("from", json_of(line.from));
        object.add("to", json_of(line.to));
        object.add("count", json_of(line.count));
    }
    void operator()(const FieldLayout& field) {
        object.add("kind", json_text("field"));
        object.add("corner", json_of(field.corner));
        object.add("along", json_of(field.along));
        object.add("across", json_of(field.across));
        object.add("columns", json_of(field.columns));
        object.add("rows", json_of(field.rows));
    }
    void operator()(const CircleLayout& circle) {
        object.add("kind", json_text("circle"));
        object.add("middle", json_of(circle.middle));
        object.add("radius", json_of(circle.radius));
        object.add("count", json_of(circle.count));
        add_angle(object, "first_angle_deg", circle.first_angle);
        if (circle.face_outward) object.add("face_outward", json_boolean(true));
    }
};

}  // namespace

JsonValue json_of(const LightScene& light_scene, const References& groups) {
    JsonValue object = json_object(light_scene.id, light_scene.name);
    JsonValue& levels = object.add("levels", json_list());
    for (const LightScene::Level& level : light_scene.levels) {
        JsonValue& made = levels.items.emplace_back(json_object());
        made.add("group", groups.of(level.group));
        made.add("dimming", json_number(level.dimming));
    }
    add_unknown(object, light_scene.unknown);
    return object;
}

JsonValue json_of(const Arrangement& arrangement, const References& luminaires) {
    JsonValue object = json_object(arrangement.id, arrangement.name);
    std::visit(LayoutWriter{object.add("layout", json_object())}, arrangement.layout);
    add_angle(object, "yaw_deg", arrangement.yaw);
    JsonValue& list = object.add("luminaires", json_list());
    for (const ObjectId id : arrangement.luminaires) list.items.push_back(id ? luminaires.of(id) : JsonValue());
    add_unknown(object, arrangement.unknown);
    return object;
}

JsonValue json_of(const ControlGroup& group) {
    JsonValue object = json_object(group.id, group.name);
    if (group.dimming != 1.0) object.add("dimming", json_number(group.dimming));
    if (group.colour_temperature != 0.0) object.add("colour_temperature_k", json_number(group.colour_temperature));
    add_unknown(object, group.unknown);
    return object;
}

}  // namespace hanei
