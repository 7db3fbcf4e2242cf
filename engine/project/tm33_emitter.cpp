#include "engine/project/tm33_emitter.h"

#include "engine/project/luminaire_text.h"
#include "engine/project/number_text.h"
#include "engine/project/photometric_table.h"
#include "engine/project/xml_elements.h"
#include "engine/scene/intensity.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <utility>

namespace hanei {
namespace {

struct Reading {
    double horizontal_deg = 0.0;
    double vertical_deg = 0.0;
    double figure = 0.0;
};

/// The fields of an emitter as numbers; a text that is none is a fault at its line.
class Numbers {
public:
    Numbers(std::string_view text, LuminaireFindings& findings) : text_(text), findings_(findings) {}

    double of(const pugi::xml_node& element, std::string_view field, std::string_view word) const {
        const std::optional<double> value = decimal_number(trimmed(word));
        if (!value)
            findings_.fault(xml_line(text_, element), std::string{field},
                            in_quotes(word) + " is no number; a plain decimal number is needed");
        return value.value_or(0.0);
    }
    std::optional<double> child(const pugi::xml_node& node, const char* name) const {
        const pugi::xml_node element = node.child(name);
        if (!element) return std::nullopt;
        return of(element, name, xml_text(element));
    }

private:
    std::string_view text_;
    LuminaireFindings& findings_;
};

/// The distribution of luminous intensity, where the schema has it or where generated files put it.
struct Distribution {
    pugi::xml_node node;
    const char* data = "IntData";
    const char* horizontal = "h";
    const char* vertical = "v";
};

Distribution distribution_of(const pugi::xml_node& emitter) {
    if (const pugi::xml_node node = emitter.child("LuminousData").child("LuminousIntensity")) return {node};
    const pugi::xml_node node = emitter.child("IntensityDistribution");
    const std::string metric = xml_text(node.child("Metric"));
    if (metric.empty() || metric == "Luminous") return {node, "IntensityData", "horz", "vert"};
    return {};
}

std::vector<Reading> readings_of(const Distribution& from, const Numbers& numbers, std::string_view text,
                                 LuminaireFindings& findings) {
    std::vector<Reading> readings;
    const std::string horizontal_field = fmt::format("{}@{}", from.data, from.horizontal);
    const std::string vertical_field = fmt::format("{}@{}", from.data, from.vertical);
    const auto angle = [&](const pugi::xml_node& data, const char* name, const std::string& field) {
        const pugi::xml_attribute attribute = data.attribute(name);
        if (attribute) return numbers.of(data, field, attribute.value());
        findings.fault(xml_line(text, data), field, "the angle is missing");
        return 0.0;
    };
    for (const pugi::xml_node& data : from.node.children(from.data)) {
        const double horizontal = angle(data, from.horizontal, horizontal_field);
        const double vertical = angle(data, from.vertical, vertical_field);
        readings.push_back({horizontal, vertical, numbers.of(data, from.data, xml_text(data))});
        if (findings.failed()) break;
    }
    return readings;
}

std::vector<double> distinct(const std::vector<Reading>& readings, double Reading::*angle) {
    std::vector<double> angles;
    for (const Reading& reading : readings) angles.push_back(reading.*angle);
    std::sort(angles.begin(), angles.end());
    angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
    return angles;
}

/// Readings in any order to a table. A fault when they do not fill it, or are not as many as announced.
std::vector<double> arrange(std::vector<Reading> readings, const Distribution& from, const Numbers& numbers, int line,
                            Photometry& photometry, LuminaireFindings& findings) {
    photometry.horizontal_deg = distinct(readings, &Reading::horizontal_deg);
    photometry.vertical_deg = distinct(readings, &Reading::vertical_deg);
    const std::size_t horizontals = photometry.horizontal_deg.size();
    const std::size_t verticals = photometry.vertical_deg.size();
    std::stable_sort(readings.begin(), readings.end(), [](const Reading& a, const Reading& b) {
        return std::pair{a.horizontal_deg, a.vertical_deg} < std::pair{b.horizontal_deg, b.vertical_deg};
    });
    bool grid = readings.size() / horizontals == verticals && readings.size() % horizontals == 0;
    std::vector<double> figures;
    for (std::size_t k = 0; grid && k < readings.size(); ++k) {
        grid = readings[k].vertical_deg == photometry.vertical_deg[k % verticals];
        figures.push_back(readings[k].figure);
    }
    const double horizontals_said = numbers.child(from.node, "NumberHorz").value_or(0.0);
    const double verticals_said = numbers.child(from.node, "NumberVert").value_or(0.0);
    const auto differs = [](double said, std::size_t found) {
        return said != 0.0 && said != static_cast<double>(found);
    };
    if (!grid) {
        findings.fault(line, from.data,
                       fmt::format("{} values at {} horizontal and {} vertical angles form no grid", readings.size(),
                                   horizontals, verticals));
    } else if (differs(horizontals_said, horizontals) || differs(verticals_said, verticals)) {
        findings.fault(line, "NumberMeasured",
                       fmt::format("{} x {} angles announced, {} x {} found", horizontals_said, verticals_said,
                                   horizontals, verticals));
    }
    return figures;
}

void check_vertical(const Photometry& photometry, int line, LuminaireFindings& findings) {
    const double pole = photometry.type == PhotometricType::C   ? 0.0
                        : photometry.type == PhotometricType::A ? -90.0
                                                                : -180.0;
    const double end = photometry.type == PhotometricType::A ? 90.0 : 180.0;
    const auto& angles = photometry.vertical_deg;
    if (angles.size() < 2 || angles.front() < pole || angles.back() > end) {
        findings.fault(line, "IntData@v",
                       fmt::format("{} angles from {} to {}; two or more from {} to {} are allowed", angles.size(),
                                   angles.front(), angles.back(), pole, end));
    }
}

/// Blanks inside the words come from the standard's own print, underscores from its schema.
std::string letters(std::string text) {
    text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c == ' ' || c == '_'; }), text.end());
    return text;
}

/// The planes decide; a word that says otherwise is told.
void check_symmetry_word(const std::string& written, const Photometry& photometry, int line,
                         LuminaireFindings& findings) {
    const std::string word = letters(written);
    const PhotometricSymmetry found = photometry.symmetry;
    const bool whole = found == PhotometricSymmetry::none;  // all planes are there: nothing is to be mirrored
    const bool agrees = word.empty() || whole || (word == "SymmBi0" && found == PhotometricSymmetry::plane_0) ||
                        (word == "SymmBi90" && found == PhotometricSymmetry::plane_90) ||
                        (word == "SymmQuad" && found == PhotometricSymmetry::quadrant) ||
                        (word == "SymmFull" && found == PhotometricSymmetry::rotational);
    if (agrees) return;
    findings.warn(line, "Symm",
                  fmt::format("{} is announced, but the planes run from {} to {}; they decide", in_quotes(written),
                              photometry.horizontal_deg.front(), photometry.horizontal_deg.back()));
}

bool is_false(const std::string& text) { return text == "false" || text == "0" || text == "False"; }

/// Relative figures to candela (read_tm33_emitter).
void scale_relative(Tm33Emitter& emitter, LuminaireFindings& findings) {
    constexpr double most_of_klm = 1100.0;  // lm: what 1000 lm of lamps give, and a tenth for rounding
    Photometry& photometry = emitter.photometry;
    photometry.absolute = false;
    const double rated = photometry.lamp_sets.empty() ? 0.0 : photometry.lamp_sets.front().lumens;
    if (!(rated > 0.0)) {
        emitter.known = false;
        findings.warn(emitter.line, "AbsolutePhotometry",
                      "relative figures without RatedLumens; they are read as candela of 1000 lm");
        return;
    }
    photometry.lamp_lumens = rated;
    if (luminous_flux(photometry).value > most_of_klm) {
        findings.warn(emitter.line, "AbsolutePhotometry",
                      fmt::format("relative figures are read as candela of lamps of {} lm (RatedLumens)", rated));
        return;
    }
    for (double& candela : photometry.candela) candela *= rated / 1000.0;
    photometry.candela_per_figure *= rated / 1000.0;
    findings.warn(
        emitter.line, "AbsolutePhotometry",
        fmt::format("relative figures are read as cd/klm and multiplied by {} (RatedLumens / 1000)", rated / 1000.0));
}

void read_lamps(const pugi::xml_node& node, const Numbers& numbers, Photometry& photometry) {
    photometry.absolute = true;
    if (const auto quantity = numbers.child(node, "Quantity"))
        photometry.lamps = static_cast<int>(std::clamp(*quantity, 0.0, 1e6));
    for (const char* name : {"InputWattage", "InputWatts"}) {
        if (const auto watts = numbers.child(node, name)) photometry.input_watts = *watts;
    }
    const std::optional<double> rated = numbers.child(node, "RatedLumens");
    if (!rated) return;
    LampSet& lamps = photometry.lamp_sets.emplace_back();
    lamps.type = xml_text(node.child("Description"));
    lamps.lumens = std::max(0.0, *rated);
    lamps.colour = xml_text(node.child("ColorTemperature").child("FixedCCT"));
    lamps.rendering = xml_text(node.child("ColorRendering").child("CIE_CRI").child("Ra"));
    lamps.watts = photometry.input_watts;
}

bool is_off_centre(const pugi::xml_node& node, const Numbers& numbers) {
    const pugi::xml_node centre = node.child("EmitterCenter");
    bool off = false;
    for (const char* name : {"LengthOffset", "WidthOffset"})
        off = off || numbers.child(centre, name).value_or(0.0) != 0.0;
    return off;
}

}  // namespace

std::optional<Tm33Emitter> read_tm33_emitter(std::string_view text, const pugi::xml_node& node, PhotometricType type,
                                             LuminaireFindings& findings) {
    const Numbers numbers{text, findings};
    const Distribution from = distribution_of(node);
    std::vector<Reading> readings = readings_of(from, numbers, text, findings);
    if (readings.empty() || findings.failed()) return std::nullopt;
    Tm33Emitter emitter;
    Photometry& photometry = emitter.photometry;
    photometry.type = type;
    emitter.name = xml_text(node.child("Description"));
    emitter.line = xml_line(text, from.node.child(from.data));
    read_lamps(node, numbers, photometry);
    const double multiplier = numbers.child(from.node, "Multiplier").value_or(1.0);
    if (multiplier < 0.0)
        findings.fault(xml_line(text, from.node.child("Multiplier")), "Multiplier",
                       fmt::format("{} found, allowed is 0 or more", multiplier));
    std::vector<double> figures = arrange(std::move(readings), from, numbers, emitter.line, photometry, findings);
    check_vertical(photometry, emitter.line, findings);
    emitter.declared_flux = numbers.child(node.child("LuminousData"), "LuminousFlux");
    emitter.areas = tm33_areas(text, node, findings);
    emitter.has_centre = is_off_centre(node, numbers);
    if (findings.failed()) return std::nullopt;
    const auto symmetry = symmetry_of(photometry.type, photometry.horizontal_deg, emitter.line, findings);
    if (!symmetry) return std::nullopt;
    photometry.symmetry = *symmetry;
    check_symmetry_word(xml_text(from.node.child("Symm")), photometry, emitter.line, findings);
    set_candela(photometry, std::move(figures), multiplier, emitter.line, findings);
    if (findings.failed()) return std::nullopt;
    if (is_false(xml_text(from.node.child("AbsolutePhotometry")))) scale_relative(emitter, findings);
    return emitter;
}

}  // namespace hanei
