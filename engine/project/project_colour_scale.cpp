#include "engine/project/project_reader.h"
#include "engine/project/project_writer.h"

namespace hanei {

void read_colour_scale(SceneReader& reader, Fields& root) {
    const JsonValue* const value = root.take("colour_scale");
    if (value == nullptr) return;
    Fields fields(root.reading(), *value, "colour_scale");
    ColourScale scale;
    fields.require("low_lx", scale.low, "the illuminance at the low end");
    fields.require("high_lx", scale.high, "the illuminance at the high end");
    fields.optional("steps", scale.steps);
    fields.optional("marks_clipped", scale.marks_clipped);
    fields.optional("isolux_lx", scale.isolux);
    scale.unknown = fields.unknown();
    reader.scene.colour_scale = std::move(scale);
}

JsonValue json_of(const ColourScale& scale) {
    JsonValue object = json_object();
    object.add("low_lx", json_number(scale.low));
    object.add("high_lx", json_number(scale.high));
    object.add("steps", json_text(scale.steps));
    if (scale.marks_clipped) object.add("marks_clipped", json_boolean(true));
    if (!scale.isolux.empty()) object.add("isolux_lx", json_of(scale.isolux));
    add_unknown(object, scale.unknown);
    return object;
}

}  // namespace hanei
