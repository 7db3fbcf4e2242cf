#include "engine/base/check.h"
#include "engine/project/json_fields.h"
#include "engine/project/project_reader.h"
#include "engine/project/project_settings.h"
#include "engine/project/project_writer.h"
#include "engine/project/text_file.h"

#include <algorithm>
#include <cmath>

namespace hanei {

JsonValue References::of(ObjectId id) const {
    const auto named = names_.find(id.value);
    return named == names_.end() ? json_number(id.value) : json_text(named->second);
}

JsonValue json_of(double number) { return json_number(number); }
JsonValue json_of(int number) { return json_number(number); }
JsonValue json_of(const std::string& text) { return json_text(text); }

JsonValue json_of(const Vec2& vector) {
    JsonValue list = json_list();
    list.items = {json_number(vector.x), json_number(vector.y)};
    return list;
}

JsonValue json_of(const Vec3& vector) {
    JsonValue list = json_list();
    list.items = {json_number(vector.x), json_number(vector.y), json_number(vector.z)};
    return list;
}

namespace {

bool is_finite(const JsonValue& value) {
    const bool lost = value.is(JsonValue::Kind::null) && !value.text.empty();
    return !lost && std::all_of(value.items.begin(), value.items.end(), is_finite);
}

}  // namespace

std::optional<Diagnostic> unwritable(const JsonValue& root, const std::filesystem::path& file) {
    if (is_finite(root)) return std::nullopt;
    return about_file(Severity::error, file.string(), 0, {},
                      "the project holds a figure that is infinite or no number; correct it before saving");
}

JsonValue json_object(ObjectId id, const std::string& name) {
    JsonValue object = json_object();
    object.add("id", json_number(id.value));
    if (!name.empty()) object.add("name", json_text(name));
    return object;
}

void add_region(JsonValue& object, const Region& region) {
    object.add("outline", json_of(region.outline));
    if (!region.holes.empty()) object.add("holes", json_of(region.holes));
}

void add_angle(JsonValue& object, std::string_view key, double angle) {
    if (angle != 0.0 || std::signbit(angle)) object.add(std::string(key), json_scaled(angle, degree));
}

namespace {

void merge(JsonValue& object, JsonValue extra) {
    for (std::size_t i = 0; i < extra.items.size(); ++i) {
        const std::string& key = extra.keys[i];
        std::size_t at = 0;
        while (at < object.keys.size() && object.keys[at] != key) ++at;
        if (at == object.keys.size())
            object.add(key, std::move(extra.items[i]));
        else if (object.items[at].is(JsonValue::Kind::object) && extra.items[i].is(JsonValue::Kind::object))
            merge(object.items[at], std::move(extra.items[i]));
    }
}

void remove(JsonValue& object, std::string_view key) {
    const auto found = std::find(object.keys.begin(), object.keys.end(), key);
    if (found == object.keys.end()) return;
    object.items.erase(object.items.begin() + (found - object.keys.begin()));
    object.keys.erase(found);
}

template <class Objects, class... Context>
void add_objects(JsonValue& root, std::string_view key, const Objects& objects, const Context&... context) {
    if (objects.empty()) return;
    JsonValue& list = root.add(std::string(key), json_list());
    for (const auto& object : objects) list.items.push_back(json_of(object, context...));
}

}  // namespace

void add_unknown(JsonValue& object, const UnknownFields& unknown) {
    if (unknown.empty()) return;
    Diagnostics findings;
    std::optional<JsonValue> extra = parse_json(unknown, {}, findings);
    HANEI_CHECK(extra.has_value() && extra->is(JsonValue::Kind::object));
    merge(object, std::move(*extra));
}

JsonValue json_of(const Material& material) {
    JsonValue object = json_object(material.id, {});
    object.add("name", json_text(material.name));
    object.add("reflectance", json_number(material.reflectance));
    if (material.tint != Vec3(1.0)) object.add("tint", json_of(material.tint));
    add_unknown(object, material.unknown);
    return object;
}

JsonValue json_of(const CalculationGrid& grid) {
    JsonValue object = json_object(grid.id, grid.name);
    object.add("corner", json_of(grid.corner));
    object.add("along", json_of(grid.along));
    object.add("across", json_of(grid.across));
    object.add("spacing", json_number(grid.spacing));
    add_unknown(object, grid.unknown);
    return object;
}

JsonValue json_of(const CalculationPoint& point) {
    JsonValue object = json_object(point.id, point.name);
    object.add("position", json_of(point.position));
    object.add("normal", json_of(point.normal));
    add_unknown(object, point.unknown);
    return object;
}

JsonValue json_of(const View& view) {
    JsonValue object = json_object(view.id, view.name);
    object.add("eye", json_of(view.eye));
    object.add("target", json_of(view.target));
    object.add("field_of_view_deg", json_scaled(view.field_of_view, degree));
    if (view.orthographic) object.add("orthographic", json_boolean(true));
    if (view.hides_ceiling) object.add("hides_ceiling", json_boolean(true));
    if (view.cut) {
        JsonValue cut = json_object();
        cut.add("normal", json_of(view.cut->normal));
        cut.add("offset", json_number(view.cut->offset));
        object.add("cut", std::move(cut));
    }
    add_unknown(object, view.unknown);
    if (!view.cut) remove(object, "cut");  // what is unknown of a cut goes with it
    return object;
}

JsonValue json_of(const Settings& settings) {
    JsonValue object = json_object();
    object.add("method", json_text(std::string(name_of(settings.method))));
    for_each_option([&](const auto& option) {
        const double value = settings.*option.member;
        object.add(field_of(option),
                   option.scale == 1.0 ? json_number(value) : json_scaled(value, {1.0L, option.scale}));
    });
    for (const EffectOption& option : effect_options)
        if (settings.*option.member != EffectChoice::by_bound)
            object.add(std::string(option.name), json_text(std::string(name_of(settings.*option.member))));
    return object;
}

JsonValue json_of(const Project& project) {
    const Scene& scene = project.scene;
    const References materials(scene.materials);
    JsonValue root = json_object();
    root.add("format", json_text("hanei-project"));
    root.add("version", json_number(project_version));
    if (!scene.title.empty()) root.add("title", json_text(scene.title));
    root.add("maintenance_factor", json_number(scene.maintenance_factor));
    root.add("settings", json_of(project.settings));
    add_objects(root, "materials", scene.materials);
    if (scene.room.has_value()) root.add("room", json_of(*scene.room, materials));
    add_objects(root, "furniture", scene.furniture, materials);
    add_objects(root, "surfaces", scene.surfaces, materials);
    add_objects(root, "control_groups", scene.control_groups);
    add_objects(root, "luminaires", scene.luminaires, References(scene.photometries), References(scene.control_groups));
    add_objects(root, "light_scenes", scene.light_scenes, References(scene.control_groups));
    add_objects(root, "arrangements", scene.arrangements, References(scene.luminaires));
    add_objects(root, "grids", scene.grids);
    add_objects(root, "points", scene.points);
    add_objects(root, "object_groups", scene.object_groups);
    add_objects(root, "views", scene.views);
    if (scene.colour_scale) root.add("colour_scale", json_of(*scene.colour_scale));
    add_objects(root, "photometries", scene.photometries);
    root.add("last_id", json_number(scene.last_id));
    add_unknown(root, scene.unknown);
    return root;
}

}  // namespace hanei
