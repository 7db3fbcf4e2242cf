#include "engine/project/project_reader.h"

namespace hanei {
namespace {

Region region_of(Fields& fields) {
    Region region;
    fields.require("outline", region.outline, "points [x, y, z], counter-clockwise seen from the shining side");
    fields.optional("holes", region.holes);
    return region;
}

Opening opening_of(Fields& fields) {
    std::string kind = "point";
    fields.require("kind", kind, "\"point\", \"line\", \"polygon\", \"polyhedron\" or \"measured\"");
    if (kind == "point") return PointOpening{};
    if (kind == "measured") return MeasuredOpening{};
    if (kind == "polygon") return PolygonOpening{region_of(fields)};
    if (kind == "line") {
        LineOpening line;
        fields.require("from", line.from, "three numbers [x, y, z]");
        fields.require("to", line.to, "three numbers [x, y, z]");
        return line;
    }
    if (kind == "polyhedron") {
        PolyhedronOpening solid;
        fields.require("vertices", solid.vertices, "points [x, y, z]");
        fields.require("faces", solid.faces, "lists of vertex numbers, counter-clockwise seen from outside");
        fields.optional("relative_luminance", solid.relative_luminance);
        return solid;
    }
    fields.error("kind", "found " + json_quoted(kind) +
                             ", expected \"point\", \"line\", \"polygon\", \"polyhedron\" or \"measured\"");
    return PointOpening{};
}

Distribution distribution_of(SceneReader& reader, Fields& fields) {
    std::string kind = "diffuse";
    fields.require("kind", kind, "\"diffuse\", \"cosine_power\" or \"measured\"");
    if (kind == "diffuse") return Diffuse{};
    if (kind == "measured") return Measured{take_photometry(reader, fields, "photometry")};
    if (kind == "cosine_power") {
        CosinePower power;
        fields.require("exponent", power.exponent, "a number, 0 or more");
        return power;
    }
    fields.error("kind", "found " + json_quoted(kind) + ", expected \"diffuse\", \"cosine_power\" or \"measured\"");
    return Diffuse{};
}

/// Exactly one of the three fields that say how much light there is.
Output output_of(Fields& fields) {
    bool as_measured = false;
    LuminousFlux flux;
    Luminance luminance;
    const int given = int{fields.has("flux_lm")} + int{fields.has("luminance_cd_m2")} + int{fields.has("as_measured")};
    fields.optional("flux_lm", flux.value);
    fields.optional("luminance_cd_m2", luminance.value);
    fields.optional("as_measured", as_measured);
    if (given == 0) fields.missing("flux_lm", "\"flux_lm\", \"luminance_cd_m2\" or \"as_measured\": true");
    if (given > 1)
        fields.reading().error(fields.value(), fields.path(),
                               "a luminaire has one of \"flux_lm\", \"luminance_cd_m2\" and \"as_measured\"; keep one");
    if (given == 1 && fields.has("as_measured") && !as_measured)
        fields.error("as_measured", "expected true; otherwise give \"flux_lm\" or \"luminance_cd_m2\" instead");
    if (fields.has("as_measured")) return AsMeasured{};
    if (fields.has("luminance_cd_m2")) return luminance;
    return flux;
}

}  // namespace

void read_luminaires(SceneReader& reader, Fields& root) {
    for_each_object(root, "luminaires", [&](Fields& fields, std::size_t) {
        Luminaire luminaire;
        JsonValue kept = json_object();
        luminaire.id = reader.take_id(fields);
        fields.optional("name", luminaire.name);
        fields.require("position", luminaire.position, "three numbers [x, y, z]");
        fields.optional_angle("yaw_deg", luminaire.yaw);
        fields.optional_angle("tilt_deg", luminaire.tilt);
        fields.optional_angle("roll_deg", luminaire.roll);
        if (const JsonValue* const value = fields.take("opening")) {
            Fields opening(reader.reading, *value, fields.path_of("opening"));
            luminaire.opening = opening_of(opening);
            keep_unknown(opening, "opening", kept);
        } else {
            fields.missing("opening", "{\"kind\": \"point\"} or another kind");
        }
        if (const JsonValue* const value = fields.take("distribution")) {
            Fields distribution(reader.reading, *value, fields.path_of("distribution"));
            luminaire.distribution = distribution_of(reader, distribution);
            keep_unknown(distribution, "distribution", kept);
        }
        luminaire.output = output_of(fields);
        fields.optional("dimming", luminaire.dimming);
        fields.optional("colour_temperature_k", luminaire.colour_temperature);
        fields.optional("opaque", luminaire.opaque);
        luminaire.group = take_control_group(reader, fields, "group");
        luminaire.unknown = unknown_of(fields, std::move(kept));
        reader.scene.luminaires.push_back(std::move(luminaire));
    });
}

}  // namespace hanei
