#include "engine/project/project_reader.h"

namespace hanei {

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
