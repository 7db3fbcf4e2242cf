#include "engine/project/project_words.h"
#include "engine/project/project_writer.h"

namespace hanei {
namespace {

std::string face_word(int face) {
    if (face == Room::floor_face) return "floor";
    if (face == Room::ceiling_face) return "ceiling";
    return "wall " + std::to_string(face - Room::wall_face(0));
}

JsonValue json_of_area(const SubArea& area, const References& materials) {
    JsonValue object = json_object(area.id, area.name);
    object.add("face", json_text(face_word(area.face)));
    object.add("low", json_of(area.low));
    object.add("high", json_of(area.high));
    object.add("material", materials.of(area.material));
    add_unknown(object, area.unknown);
    return object;
}

JsonValue json_of_part(const Part& part, const References& materials) {
    JsonValue object = json_object();
    if (const auto* const box = std::get_if<BoxShape>(&part.shape)) object.add("box", json_of(box->size));
    if (const auto* const solid = std::get_if<SolidShape>(&part.shape)) {
        object.add("vertices", json_of(solid->vertices));
        object.add("faces", json_of(solid->faces));
    }
    object.add("position", json_of(part.position));
    add_angle(object, "rotation_deg", part.rotation);
    object.add("material", materials.of(part.material));
    add_unknown(object, part.unknown);
    return object;
}

struct OpeningWriter {
    JsonValue& object;

    void kind(const char* word) const { object.add("kind", json_text(word)); }
    void operator()(const PointOpening&) const { kind("point"); }
    void operator()(const MeasuredOpening&) const { kind("measured"); }
    void operator()(const LineOpening& line) const {
        kind("line");
        object.add("from", json_of(line.from));
        object.add("to", json_of(line.to));
    }
    void operator()(const PolygonOpening& polygon) const {
        kind("polygon");
        add_region(object, polygon.region);
    }
    void operator()(const PolyhedronOpening& solid) const {
        kind("polyhedron");
        object.add("vertices", json_of(solid.vertices));
        object.add("faces", json_of(solid.faces));
        if (!solid.relative_luminance.empty()) object.add("relative_luminance", json_of(solid.relative_luminance));
    }
};

void add_distribution(JsonValue& object, const Distribution& distribution, const References& photometries) {
    if (std::holds_alternative<Diffuse>(distribution)) return;
    JsonValue& value = object.add("distribution", json_object());
    if (const auto* const power = std::get_if<CosinePower>(&distribution)) {
        value.add("kind", json_text("cosine_power"));
        value.add("exponent", json_number(power->exponent));
    }
    if (const auto* const measured = std::get_if<Measured>(&distribution)) {
        value.add("kind", json_text("measured"));
        value.add("photometry", photometries.of(measured->photometry));
    }
}

void add_output(JsonValue& object, const Output& output) {
    if (const auto* const flux = std::get_if<LuminousFlux>(&output)) object.add("flux_lm", json_number(flux->value));
    if (const auto* const luminance = std::get_if<Luminance>(&output))
        object.add("luminance_cd_m2", json_number(luminance->value));
    if (std::holds_alternative<AsMeasured>(output)) object.add("as_measured", json_boolean(true));
}

}  // namespace

JsonValue json_of(const Room& room, const References& materials) {
    JsonValue object = json_object(room.id, room.name);
    object.add("plan", json_of(room.plan));
    object.add("floor_height", json_number(room.floor_height));
    object.add("height", json_number(room.height));
    object.add("floor", materials.of(room.floor_material));
    object.add("ceiling", materials.of(room.ceiling_material));
    JsonValue& walls = object.add("walls", json_list());
    for (const ObjectId material : room.wall_materials) walls.items.push_back(materials.of(material));
    if (!room.sub_areas.empty()) {
        JsonValue& areas = object.add("sub_areas", json_list());
        for (const SubArea& area : room.sub_areas) areas.items.push_back(json_of_area(area, materials));
    }
    add_unknown(object, room.unknown);
    return object;
}

JsonValue json_of(const Furniture& furniture, const References& materials) {
    JsonValue object = json_object(furniture.id, furniture.name);
    object.add("position", json_of(furniture.position));
    add_angle(object, "rotation_deg", furniture.rotation);
    if (!furniture.model.kind.empty()) {
        JsonValue& model = object.add("model", json_object());
        model.add("kind", json_text(furniture.model.kind));
        if (!furniture.model.sizes.empty()) {
            JsonValue& sizes = model.add("sizes", json_object());
            for (const ModelSize& size : furniture.model.sizes) sizes.add(size.name, json_number(size.metres));
        }
    }
    JsonValue& parts = object.add("parts", json_list());
    for (const Part& part : furniture.parts) parts.items.push_back(json_of_part(part, materials));
    add_unknown(object, furniture.unknown);
    return object;
}

JsonValue json_of(const FreeSurface& surface, const References& materials) {
    JsonValue object = json_object(surface.id, surface.name);
    add_region(object, surface.region);
    object.add("material", materials.of(surface.material));
    if (surface.own_exitance.value != 0.0) object.add("exitance_lm_m2", json_number(surface.own_exitance.value));
    add_unknown(object, surface.unknown);
    return object;
}

JsonValue json_of(const Luminaire& luminaire, const References& photometries, const References& groups) {
    JsonValue object = json_object(luminaire.id, luminaire.name);
    object.add("position", json_of(luminaire.position));
    add_angle(object, "yaw_deg", luminaire.yaw);
    add_angle(object, "tilt_deg", luminaire.tilt);
    add_angle(object, "roll_deg", luminaire.roll);
    std::visit(OpeningWriter{object.add("opening", json_object())}, luminaire.opening);
    add_distribution(object, luminaire.distribution, photometries);
    add_output(object, luminaire.output);
    if (luminaire.dimming != 1.0) object.add("dimming", json_number(luminaire.dimming));
    if (luminaire.colour_temperature != 0.0)
        object.add("colour_temperature_k", json_number(luminaire.colour_temperature));
    if (luminaire.opaque) object.add("opaque", json_boolean(true));
    if (luminaire.group) object.add("group", groups.of(luminaire.group));
    add_unknown(object, luminaire.unknown);
    return object;
}

}  // namespace hanei
