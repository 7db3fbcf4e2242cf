#include "engine/project/project_reader.h"

#include "engine/project/json_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hanei {

bool is_id(const JsonValue& value) {
    constexpr double greatest = std::numeric_limits<std::uint32_t>::max() - 1.0;
    return value.is(JsonValue::Kind::number) && value.number == std::floor(value.number) && value.number >= 1.0 &&
           value.number <= greatest;
}

namespace {

std::uint32_t greatest_in(const JsonValue* object) {
    const JsonValue* const id = object == nullptr ? nullptr : object->find("id");
    return id != nullptr && is_id(*id) ? static_cast<std::uint32_t>(id->number) : 0;
}

std::uint32_t greatest_in_list(const JsonValue* list) {
    std::uint32_t greatest = 0;
    if (list != nullptr && list->is(JsonValue::Kind::list))
        for (const JsonValue& item : list->items) greatest = std::max(greatest, greatest_in(&item));
    return greatest;
}

template <class Object>
std::string names_of(const std::vector<Object>& objects) {
    constexpr std::size_t most = 8;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, objects.size()); ++i)
        text += (i == 0 ? "" : ", ") + json_quoted(objects[i].name);
    if (objects.empty()) return "there are none";
    return "there are " + text + (objects.size() > most ? ", ..." : "");
}

template <class Object>
ObjectId resolve(JsonReading& reading, const JsonValue& value, const std::string& path, std::string_view kind,
                 const std::vector<Object>& among) {
    const bool by_id = is_id(value);
    if (!by_id && !value.is(JsonValue::Kind::text)) {
        reading.error(value, path,
                      "found " + described(value) + ", expected the name or the id of a " + std::string(kind));
        return {};
    }
    const auto meant = [&](const Object& object) {
        return by_id ? object.id.value == static_cast<std::uint32_t>(value.number) : object.name == value.text;
    };
    const auto count = std::count_if(among.begin(), among.end(), meant);
    if (count == 1) return std::find_if(among.begin(), among.end(), meant)->id;
    if (count == 0)
        reading.error(value, path,
                      "there is no " + std::string(kind) + ' ' + described(value) + "; " + names_of(among));
    else
        reading.error(value, path,
                      std::to_string(count) + " of the kind " + std::string(kind) + " are named " + described(value) +
                          "; refer to it by its id, or rename");
    return {};
}

}  // namespace

ObjectId SceneReader::take_id(Fields& fields) {
    const JsonValue* const given = fields.take("id");
    if (given == nullptr) return scene.new_id();
    if (!is_id(*given)) {
        fields.error("id", "found " + described(*given) + ", expected a whole number from 1 to 4294967294");
        return scene.new_id();
    }
    const ObjectId id{static_cast<std::uint32_t>(given->number)};
    const auto [place, is_new] = ids.emplace(id.value, fields.path());
    if (!is_new)
        fields.error("id", "the id " + given->text + " is already that of " + place->second +
                               "; leave the field out to get a new one");
    return id;
}

std::uint32_t greatest_id(const JsonValue& root) {
    std::uint32_t greatest = 0;
    for (const char* list : {"materials", "furniture", "surfaces", "photometries", "luminaires", "grids", "points",
                             "views", "control_groups", "light_scenes", "arrangements", "object_groups"})
        greatest = std::max(greatest, greatest_in_list(root.find(list)));
    const JsonValue* const room = root.find("room");
    if (room != nullptr) greatest = std::max({greatest, greatest_in(room), greatest_in_list(room->find("sub_areas"))});
    const JsonValue* const last = root.find("last_id");
    if (last != nullptr && is_id(*last)) greatest = std::max(greatest, static_cast<std::uint32_t>(last->number));
    return greatest;
}

ObjectId material_of(SceneReader& reader, const JsonValue& value, const std::string& path) {
    return resolve(reader.reading, value, path, "material", reader.scene.materials);
}

ObjectId take_material(SceneReader& reader, Fields& fields, std::string_view key) {
    const JsonValue* const value = fields.take(key);
    if (value != nullptr) return material_of(reader, *value, fields.path_of(key));
    fields.missing(key, "the name of a material");
    return {};
}

ObjectId take_photometry(SceneReader& reader, Fields& fields, std::string_view key) {
    const JsonValue* const value = fields.take(key);
    if (value != nullptr)
        return resolve(fields.reading(), *value, fields.path_of(key), "photometry", reader.scene.photometries);
    fields.missing(key, "the name of a photometry");
    return {};
}

ObjectId take_control_group(SceneReader& reader, Fields& fields, std::string_view key) {
    const JsonValue* const value = fields.take(key);
    if (value == nullptr) return {};
    std::vector<ControlGroup>& groups = reader.scene.control_groups;
    if (!value->is(JsonValue::Kind::text))
        return resolve(reader.reading, *value, fields.path_of(key), "control group", groups);
    const auto named = [&](const ControlGroup& group) { return group.name == value->text; };
    if (value->text.empty()) return {};
    if (std::none_of(groups.begin(), groups.end(), named)) {
        ControlGroup group;
        group.id = reader.scene.new_id();
        group.name = value->text;
        groups.push_back(std::move(group));
    }
    return resolve(reader.reading, *value, fields.path_of(key), "control group", groups);
}

ObjectId take_known_control_group(SceneReader& reader, Fields& fields, std::string_view key) {
    const JsonValue* const value = fields.take(key);
    if (value != nullptr)
        return resolve(reader.reading, *value, fields.path_of(key), "control group", reader.scene.control_groups);
    fields.missing(key, "the name of a control group");
    return {};
}

ObjectId luminaire_of(SceneReader& reader, const JsonValue& value, const std::string& path) {
    return resolve(reader.reading, value, path, "luminaire", reader.scene.luminaires);
}

void keep_unknown(Fields& child, std::string_view key, JsonValue& kept) {
    JsonValue rest = child.unknown_object();
    if (!rest.items.empty()) kept.add(std::string(key), std::move(rest));
}

std::string unknown_of(Fields& fields, JsonValue kept) {
    JsonValue all = fields.unknown_object();
    for (std::size_t i = 0; i < kept.items.size(); ++i) all.add(kept.keys[i], std::move(kept.items[i]));
    return all.items.empty() ? std::string() : one_line(all);
}

}  // namespace hanei
