#include "engine/project/project_writer.h"

namespace hanei {

JsonValue json_of(const ControlGroup& group) {
    JsonValue object = json_object(group.id, group.name);
    if (group.dimming != 1.0) object.add("dimming", json_number(group.dimming));
    if (group.colour_temperature != 0.0) object.add("colour_temperature_k", json_number(group.colour_temperature));
    add_unknown(object, group.unknown);
    return object;
}

}  // namespace hanei
