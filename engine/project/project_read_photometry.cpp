#include "engine/project/luminaires.h"
#include "engine/project/project_reader.h"
#include "engine/project/project_words.h"
#include "engine/scene/intensity.h"

#include <algorithm>
#include <utility>

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

void take_side_heights(Fields& fields, MeasuredOpeningSize& opening) {
    std::vector<double> heights;
    if (!fields.optional("side_heights", heights)) return;
    std::array<double, 4>& sides = opening.side_heights.emplace();
    if (heights.size() == sides.size())
        std::copy(heights.begin(), heights.end(), sides.begin());
    else
        fields.error("side_heights", "found " + std::to_string(heights.size()) +
                                         " heights, expected 4: of the sides at planes 0, 90, 180 and 270");
}

void take_opening_size(Fields& fields, MeasuredOpeningSize& opening, JsonValue& kept) {
    const JsonValue* const value = fields.take("opening");
    if (value == nullptr) return fields.missing("opening", "{\"shape\": ..., \"extent_0\": ...}");
    Fields size(fields.reading(), *value, fields.path_of("opening"));
    take_word(size, "shape", opening_shape_words, opening.shape);
    size.optional("extent_0", opening.extent_0);
    size.optional("extent_90", opening.extent_90);
    size.optional("height", opening.height);
    take_side_heights(size, opening);
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

/// Which of its lamp sets the photometry's figures are for.
void take_lamp_set(Fields& fields, Photometry& photometry) {
    int set = 0;
    if (!fields.optional("lamp_set", set)) return;
    const std::size_t count = photometry.lamp_sets.size();
    if (set >= 0 && static_cast<std::size_t>(set) < count)
        photometry.lamp_set = static_cast<std::size_t>(set);
    else
        fields.error("lamp_set", "found " + std::to_string(set) + ", the photometry has " + std::to_string(count) +
                                     " lamp sets, counted from 0");
}

void take_quarter_turns(Fields& fields, Photometry& photometry) {
    int turns = 0;
    if (!fields.optional("quarter_turns", turns)) return;
    if (turns >= 0 && turns <= 3)
        photometry.quarter_turns = turns;
    else
        fields.error("quarter_turns", "found " + std::to_string(turns) + ", expected 0, 1, 2 or 3");
}

Photometry embedded(Fields& fields, JsonValue& kept) {
    Photometry photometry;
    fields.optional("source_file", photometry.source_file);
    fields.optional("source_format", photometry.format);
    take_word(fields, "type", photometric_type_words, photometry.type);
    take_word(fields, "symmetry", symmetry_words, photometry.symmetry);
    take_opening_size(fields, photometry.opening, kept);
    take_lamps(fields, photometry);
    take_lamp_set(fields, photometry);
    take_quarter_turns(fields, photometry);
    take_declared(fields, photometry, kept);
    take_keywords(fields, photometry);
    fields.optional("warnings", photometry.warnings);
    fields.require("horizontal_deg", photometry.horizontal_deg, "increasing angles");
    fields.require("vertical_deg", photometry.vertical_deg, "increasing angles");
    take_candela(fields, photometry);
    return photometry;
}

/// The one that is asked for of a file's luminaires; the only one when none is.
Photometry chosen(Fields& fields, const std::string& file, LuminairesRead read) {
    std::string wanted;
    const bool asked = fields.optional("luminaire", wanted);
    std::string names;
    for (NamedPhotometry& luminaire : read.luminaires) {
        if (asked ? luminaire.name == wanted : read.luminaires.size() == 1) return std::move(luminaire.photometry);
        names += (names.empty() ? "" : ", ") + json_quoted(luminaire.name);
    }
    if (read.luminaires.empty())
        fields.error("file", "the luminaire file " + json_quoted(file) + " cannot be used; see its own messages");
    else
        fields.error(asked ? "luminaire" : "file", "expected \"luminaire\" to be one of " + names);
    return {};
}

Photometry from_file(SceneReader& reader, Fields& fields) {
    std::string name;
    if (!fields.optional("file", name)) return {};
    if (name.empty() || std::filesystem::path(name).is_absolute()) {
        fields.error("file", "found " + json_quoted(name) + ", expected a path relative to the project file's folder");
        return {};
    }
    LuminairesRead read = read_luminaires(reader.folder / std::filesystem::path(name));
    for (Diagnostic& finding : read.findings) {
        if (!read.luminaires.empty()) finding.severity = std::min(finding.severity, Severity::warning);
        reader.reading.findings.push_back(std::move(finding));
    }
    read.findings.clear();
    Photometry photometry = chosen(fields, name, std::move(read));
    const std::size_t set = photometry.lamp_set;
    take_lamp_set(fields, photometry);
    const std::size_t wanted = std::exchange(photometry.lamp_set, set);
    if (wanted != set) photometry = with_lamp_set(std::move(photometry), wanted);
    take_quarter_turns(fields, photometry);
    return photometry;
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
