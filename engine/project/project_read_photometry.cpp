#include "engine/project/luminaire_file.h"
#include "engine/project/project_reader.h"
#include "engine/project/project_words.h"

namespace hanei {
namespace {

template <class Enum, std::size_t count>
void take_word(Fields& fields, std::string_view key, const Words<Enum, count>& words, Enum& target) {
    std::string text;
    std::string allowed;
    for (const auto& [value, word] : words) allowed += (allowed.empty() ? "" : ", ") + json_quoted(word);
    if (!fields.require(key, text, "one of " + allowed)) return;
    for (const auto& [value, word] : words) {
        if (word != text) continue;
        target = value;
        return;
    }
    fields.error(key, "found " + json_quoted(text) + ", expected one of " + allowed);
}

void take_opening_size(Fields& fields, MeasuredOpeningSize& opening, JsonValue& kept) {
    const JsonValue* const value = fields.take("opening");
    if (value == nullptr) return fields.missing("opening", "{\"shape\": ..., \"extent_0\": ...}");
    Fields size(fields.reading(), *value, fields.path_of("opening"));
    take_word(size, "shape", opening_shape_words, opening.shape);
    size.optional("extent_0", opening.extent_0);
    size.optional("extent_90", opening.extent_90);
    size.optional("height", opening.height);
    keep_unknown(size, "opening", kept);
}

LampSet lamp_set_of(Fields& fields) {
    LampSet lamps;
    fields.optional("count", lamps.count);
    fields.optional("type", lamps.type);
    fields.optional("lumens_lm", lamps.lumens);
    fields.optional("colour", lamps.colour);
    fields.optional("rendering", lamps.rendering);
    fields.optional("watts", lamps.watts);
    fields.drop_unknown();
    return lamps;
}

void take_lamps(Fields& fields, Photometry& photometry) {
    fields.optional("lamps", photometry.lamps);
    fields.optional("lamp_lumens_lm", photometry.lamp_lumens);
    fields.optional("absolute", photometry.absolute);
    fields.optional("input_watts", photometry.input_watts);
    for_each_object(fields, "lamp_sets",
                    [&](Fields& lamps, std::size_t) { photometry.lamp_sets.push_back(lamp_set_of(lamps)); });
}

void take_tilt(Fields& fields, Photometry& photometry, JsonValue& kept) {
    const JsonValue* const value = fields.take("tilt");
    if (value == nullptr) return;
    Fields tilt(fields.reading(), *value, fields.path_of("tilt"));
    LampTilt& target = photometry.tilt.emplace();
    tilt.optional("file", target.file);
    tilt.optional("geometry", target.geometry);
    tilt.optional("angle_deg", target.angle_deg);
    tilt.optional("factor", target.factor);
    keep_unknown(tilt, "tilt", kept);
}

void take_share(Fields& fields, std::string_view key, std::optional<double>& target) {
    double share = 0.0;
    if (fields.optional(key, share)) target = share;
}

/// What the luminaire file said about itself.
void take_declared(Fields& fields, Photometry& photometry, JsonValue& kept) {
    fields.optional("candela_per_figure", photometry.candela_per_figure);
    take_share(fields, "declared_output_ratio", photometry.declared_output_ratio);
    take_share(fields, "declared_downward_share", photometry.declared_downward_share);
    take_tilt(fields, photometry, kept);
}

void take_keywords(Fields& fields, Photometry& photometry) {
    std::vector<std::vector<std::string>> keywords;
    fields.optional("keywords", keywords);
    for (std::vector<std::string>& pair : keywords) {
        if (pair.size() == 2)
            photometry.keywords.emplace_back(std::move(pair[0]), std::move(pair[1]));
        else
            fields.error("keywords", "expected pairs [\"keyword\", \"text\"]");
    }
}

/// One list of candela a plane, as many in each as there are vertical angles.
void take_candela(Fields& fields, Photometry& photometry) {
    std::vector<std::vector<double>> planes;
    if (!fields.require("candela", planes, "a list of candela values for every horizontal angle")) return;
    if (planes.size() != photometry.horizontal_deg.size())
        fields.error("candela", std::to_string(photometry.horizontal_deg.size()) + " horizontal angles announced, " +
                                    std::to_string(planes.size()) + " planes found");
    for (std::size_t plane = 0; plane < planes.size(); ++plane) {
        if (planes[plane].size() != photometry.vertical_deg.size())
            fields.error("candela",
                         "plane " + std::to_string(plane) + ": " + std::to_string(photometry.vertical_deg.size()) +
                             " vertical angles announced, " + std::to_string(planes[plane].size()) + " values found");
        photometry.candela.insert(photometry.candela.end(), planes[plane].begin(), planes[plane].end());
    }
}

Photometry embedded(Fields& fields, JsonValue& kept) {
    Photometry photometry;
    fields.optional("source_file", photometry.source_file);
    fields.optional("source_format", photometry.format);
    take_word(fields, "type", photometric_type_words, photometry.type);
    take_word(fields, "symmetry", symmetry_words, photometry.symmetry);
    take_opening_size(fields, photometry.opening, kept);
    take_lamps(fields, photometry);
    take_declared(fields, photometry, kept);
    take_keywords(fields, photometry);
    fields.optional("warnings", photometry.warnings);
    fields.require("horizontal_deg", photometry.horizontal_deg, "increasing angles");
    fields.require("vertical_deg", photometry.vertical_deg, "increasing angles");
    take_candela(fields, photometry);
    return photometry;
}

Photometry from_file(SceneReader& reader, Fields& fields) {
    std::string name;
    if (!fields.optional("file", name)) return {};
    if (name.empty() || std::filesystem::path(name).is_absolute()) {
        fields.error("file", "found " + json_quoted(name) + ", expected a path relative to the project file's folder");
        return {};
    }
    LuminaireFileRead read = read_luminaire_file(reader.folder / std::filesystem::path(name));
    Diagnostics& findings = reader.reading.findings;
    findings.insert(findings.end(), read.findings.begin(), read.findings.end());
    if (read.photometry.has_value()) return std::move(*read.photometry);
    fields.error("file", "the luminaire file " + json_quoted(name) + " cannot be used; see its own messages");
    return {};
}

}  // namespace

void read_photometries(SceneReader& reader, Fields& root) {
    for_each_object(root, "photometries", [&](Fields& fields, std::size_t) {
        JsonValue kept = json_object();
        const ObjectId id = reader.take_id(fields);
        Photometry photometry = fields.has("file") ? from_file(reader, fields) : embedded(fields, kept);
        photometry.id = id;
        fields.optional("name", photometry.name);
        photometry.unknown = unknown_of(fields, std::move(kept));
        reader.scene.photometries.push_back(std::move(photometry));
    });
}

}  // namespace hanei
