#include "engine/project/project_words.h"
#include "engine/project/project_writer.h"

#include <algorithm>

namespace hanei {
namespace {

JsonValue planes_of(const Photometry& photometry) {
    JsonValue planes = json_list();
    const std::size_t angles = photometry.vertical_deg.size();
    for (std::size_t begin = 0; angles > 0 && begin < photometry.candela.size(); begin += angles) {
        JsonValue& plane = planes.items.emplace_back(json_list());
        for (std::size_t i = begin; i < std::min(begin + angles, photometry.candela.size()); ++i)
            plane.items.push_back(json_number(photometry.candela[i]));
    }
    return planes;
}

JsonValue json_of_opening(const MeasuredOpeningSize& opening) {
    JsonValue object = json_object();
    object.add("shape", json_text(std::string(word_of(opening_shape_words, opening.shape))));
    object.add("extent_0", json_number(opening.extent_0));
    object.add("extent_90", json_number(opening.extent_90));
    object.add("height", json_number(opening.height));
    if (opening.side_heights)
        object.add("side_heights",
                   json_of(std::vector<double>(opening.side_heights->begin(), opening.side_heights->end())));
    return object;
}

JsonValue json_of_lamps(const LampSet& lamps) {
    JsonValue object = json_object();
    object.add("count", json_number(lamps.count));
    object.add("type", json_text(lamps.type));
    object.add("lumens_lm", json_number(lamps.lumens));
    object.add("colour", json_text(lamps.colour));
    object.add("rendering", json_text(lamps.rendering));
    object.add("watts", json_number(lamps.watts));
    return object;
}

JsonValue json_of_tilt(const LampTilt& tilt) {
    JsonValue object = json_object();
    object.add("file", json_text(tilt.file));
    object.add("geometry", json_number(tilt.geometry));
    object.add("angle_deg", json_of(tilt.angle_deg));
    object.add("factor", json_of(tilt.factor));
    return object;
}

void add_lamps(JsonValue& object, const Photometry& photometry) {
    object.add("lamps", json_number(photometry.lamps));
    object.add("lamp_lumens_lm", json_number(photometry.lamp_lumens));
    object.add("absolute", json_boolean(photometry.absolute));
    object.add("input_watts", json_number(photometry.input_watts));
    if (photometry.lamp_sets.empty()) return;
    JsonValue& sets = object.add("lamp_sets", json_list());
    for (const LampSet& lamps : photometry.lamp_sets) sets.items.push_back(json_of_lamps(lamps));
    if (photometry.lamp_set != 0) object.add("lamp_set", json_number(static_cast<double>(photometry.lamp_set)));
}

/// What the luminaire file says about itself.
void add_declared(JsonValue& object, const Photometry& photometry) {
    object.add("candela_per_figure", json_number(photometry.candela_per_figure));
    if (photometry.declared_output_ratio.has_value())
        object.add("declared_output_ratio", json_number(*photometry.declared_output_ratio));
    if (photometry.declared_downward_share.has_value())
        object.add("declared_downward_share", json_number(*photometry.declared_downward_share));
    if (photometry.tilt.has_value()) object.add("tilt", json_of_tilt(*photometry.tilt));
    if (!photometry.keywords.empty()) {
        JsonValue& keywords = object.add("keywords", json_list());
        for (const auto& [keyword, text] : photometry.keywords)
            keywords.items.push_back(json_of(std::vector<std::string>{keyword, text}));
    }
    if (!photometry.warnings.empty()) object.add("warnings", json_of(photometry.warnings));
}

}  // namespace

JsonValue json_of(const Photometry& photometry) {
    JsonValue object = json_object(photometry.id, photometry.name);
    if (!photometry.source_file.empty()) object.add("source_file", json_text(photometry.source_file));
    if (!photometry.format.empty()) object.add("source_format", json_text(photometry.format));
    object.add("type", json_text(std::string(word_of(photometric_type_words, photometry.type))));
    object.add("symmetry", json_text(std::string(word_of(symmetry_words, photometry.symmetry))));
    object.add("opening", json_of_opening(photometry.opening));
    add_lamps(object, photometry);
    if (photometry.quarter_turns != 0) object.add("quarter_turns", json_number(photometry.quarter_turns));
    add_declared(object, photometry);
    object.add("horizontal_deg", json_of(photometry.horizontal_deg));
    object.add("vertical_deg", json_of(photometry.vertical_deg));
    object.add("candela", planes_of(photometry));
    add_unknown(object, photometry.unknown);
    return object;
}

}  // namespace hanei
