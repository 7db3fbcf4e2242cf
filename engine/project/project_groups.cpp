#include "engine/project/project_reader.h"
#include "engine/project/project_writer.h"

#include <algorithm>
#include <fmt/format.h>

namespace hanei {
namespace {

/// Ids of all that may be in a group, and of this name among them.
struct Grouped {
    std::vector<ObjectId> all, named;
};

Grouped groupable(const Scene& scene, const std::string& name) {
    Grouped found;
    const auto search = [&](const auto& list) {
        for (const auto& object : list) {
            found.all.push_back(object.id);
            if (object.name == name) found.named.push_back(object.id);
        }
    };
    search(scene.furniture);
    search(scene.surfaces);
    search(scene.luminaires);
    search(scene.grids);
    search(scene.points);
    return found;
}

ObjectId member_of(SceneReader& reader, const JsonValue& value, const std::string& path) {
    const Grouped among = groupable(reader.scene, value.is(JsonValue::Kind::text) ? value.text : std::string());
    if (value.is(JsonValue::Kind::number)) {
        const auto found = std::find_if(among.all.begin(), among.all.end(),
                                        [&](ObjectId id) { return static_cast<double>(id.value) == value.number; });
        if (found != among.all.end()) return *found;
    } else if (value.is(JsonValue::Kind::text) && among.named.size() == 1) {
        return among.named.front();
    }
    const char* const why = value.is(JsonValue::Kind::text) && among.named.size() > 1
                                ? "several objects are named so; refer to one by its id"
                                : "expected the id or name of a piece of furniture, a surface, a "
                                  "luminaire, a grid or a point";
    reader.reading.error(value, path, fmt::format("found {}, {}", described(value), why));
    return {};
}

}  // namespace

void read_object_groups(SceneReader& reader, Fields& root) {
    for_each_object(root, "object_groups", [&](Fields& fields, std::size_t) {
        ObjectGroup group;
        group.id = reader.take_id(fields);
        fields.optional("name", group.name);
        const JsonValue* const list = fields.take("members");
        if (list == nullptr) fields.missing("members", "the ids or names of its objects");
        if (list != nullptr && take_list(reader.reading, *list, fields.path_of("members")))
            for (std::size_t i = 0; i < list->items.size(); ++i) {
                const std::string path = fmt::format("{}[{}]", fields.path_of("members"), i);
                if (const ObjectId member = member_of(reader, list->items[i], path)) group.members.push_back(member);
            }
        group.unknown = fields.unknown();
        reader.scene.object_groups.push_back(std::move(group));
    });
}

JsonValue json_of(const ObjectGroup& group) {
    JsonValue object = json_object(group.id, group.name);
    JsonValue& members = object.add("members", json_list());
    for (const ObjectId member : group.members) members.items.push_back(json_number(member.value));
    add_unknown(object, group.unknown);
    return object;
}

}  // namespace hanei
