#include "engine/project/tm33_file.h"

#include "engine/project/luminaire_text.h"
#include "engine/project/number_text.h"
#include "engine/project/photometric_table.h"
#include "engine/project/xml_elements.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <string>
#include <utility>
#include <vector>

namespace hanei {
namespace {

struct Reading {
    double horizontal_deg = 0.0;
    double vertical_deg = 0.0;
    double figure = 0.0;
};

/// What is gathered on the way through the file.
struct Gathered {
    std::string root;
    int root_line = 0;
    std::vector<Reading> readings;
    int first_line = 0;  ///< of the readings
    double multiplier = 1.0;
    double announced_horizontals = 0.0, announced_verticals = 0.0;  ///< 0: not announced
    int emitters = 0;
    bool other_quantity = false;  ///< radiant or photon data stand in the file
    bool relative = false;
    bool length_along_90 = false;
    int areas = 0;  ///< luminous areas of all faces
    double area_length = 0.0, area_width = 0.0;
    bool area_round = false;
};

double number_in(const XmlElement& xml, std::string_view field, std::string_view text, LuminaireFindings& findings) {
    const auto value = decimal_number(trimmed(text));
    if (!value)
        findings.fault(xml.line, std::string{field},
                       in_quotes(text) + " is no number; a plain decimal number is needed");
    return value.value_or(0.0);
}

void read_reading(const XmlElement& xml, Gathered& gathered, LuminaireFindings& findings) {
    for (const char* name : {"h", "v"}) {
        if (!xml.attribute(name)) {
            return findings.fault(xml.line, fmt::format("IntData@{}", name), "the angle is missing");
        }
    }
    if (gathered.readings.empty()) gathered.first_line = xml.line;
    gathered.readings.push_back({number_in(xml, "IntData@h", *xml.attribute("h"), findings),
                                 number_in(xml, "IntData@v", *xml.attribute("v"), findings),
                                 number_in(xml, "IntData", xml.text, findings)});
}

/// True when the path ends with these names.
bool is_at(const XmlElement& xml, std::string_view end) {
    const std::string& path = xml.path;
    if (!path.ends_with(end)) return false;
    return path.size() == end.size() || path[path.size() - end.size() - 1] == '/';
}

bool is_type(const XmlElement& xml, char type) {
    const std::string& text = xml.text;
    return !text.empty() && text.back() == type;
}

void read_emitter_figures(const XmlElement& xml, Photometry& photometry, Gathered& gathered,
                          LuminaireFindings& findings) {
    const auto number = [&](std::string_view field) { return number_in(xml, field, xml.text, findings); };
    if (is_at(xml, "LuminousIntensity/IntData")) read_reading(xml, gathered, findings);
    if (is_at(xml, "LuminousIntensity/Multiplier")) gathered.multiplier = number("Multiplier");
    if (is_at(xml, "LuminousIntensity/NumberHorz")) gathered.announced_horizontals = number("NumberHorz");
    if (is_at(xml, "LuminousIntensity/NumberVert")) gathered.announced_verticals = number("NumberVert");
    if (is_at(xml, "LuminousIntensity/AbsolutePhotometry")) gathered.relative = xml.text == "false" || xml.text == "0";
    if (is_at(xml, "PhotonData") || is_at(xml, "RadiantData")) gathered.other_quantity = true;
    if (is_at(xml, "Emitter/Quantity")) photometry.lamps = static_cast<int>(std::clamp(number("Quantity"), 0.0, 1e6));
    if (is_at(xml, "Emitter/RatedLumens")) photometry.lamp_sets = {{1.0, "", number("RatedLumens"), "", "", 0.0}};
    if (is_at(xml, "Emitter/InputWattage")) photometry.input_watts = number("InputWattage");
    if (is_at(xml, "Emitter")) ++gathered.emitters;
}

void read_area(const XmlElement& xml, Gathered& gathered, LuminaireFindings& findings) {
    if (xml.path.find("/EmissionAreas/") == std::string::npos) return;
    const auto number = [&](std::string_view field) { return number_in(xml, field, xml.text, findings); };
    if (is_at(xml, "BottomArea/Length")) gathered.area_length = number("Length");
    if (is_at(xml, "BottomArea/Width")) gathered.area_width = number("Width");
    if (is_at(xml, "BottomArea/Circular")) gathered.area_round = xml.text == "true" || xml.text == "1";
    if (xml.path.ends_with("Area")) gathered.areas += xml.path.ends_with("/BottomArea") ? 1 : 2;
}

void read_header(const XmlElement& xml, Photometry& photometry, Gathered& gathered) {
    if (gathered.root.empty()) {
        gathered.root = xml.path;
        gathered.root_line = xml.line;
    }
    const std::size_t header = xml.path.find("/Header/");
    if (header != std::string::npos) photometry.keywords.emplace_back(xml.path.substr(header + 8), xml.text);
    if (is_at(xml, "Header/Description")) photometry.name = xml.text;
    if (std::count(xml.path.begin(), xml.path.end(), '/') == 1 && is_at(xml, "Version")) {
        photometry.format = "TM-33 " + xml.text;
    }
    if (!is_at(xml, "Gonioradiometer/Type")) return;
    photometry.type = is_type(xml, 'A')   ? PhotometricType::A
                      : is_type(xml, 'B') ? PhotometricType::B
                                          : PhotometricType::C;
    gathered.length_along_90 = xml.text.starts_with("CIE");
}

std::vector<double> distinct(const std::vector<Reading>& readings, double Reading::*angle) {
    std::vector<double> angles;
    for (const Reading& reading : readings) angles.push_back(reading.*angle);
    std::sort(angles.begin(), angles.end());
    angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
    return angles;
}

/// Readings in any order to a table. A fault when they do not fill it.
std::vector<double> arrange(Gathered& gathered, Photometry& photometry, LuminaireFindings& findings) {
    std::vector<Reading>& readings = gathered.readings;
    photometry.horizontal_deg = distinct(readings, &Reading::horizontal_deg);
    photometry.vertical_deg = distinct(readings, &Reading::vertical_deg);
    const std::size_t horizontals = photometry.horizontal_deg.size();
    const std::size_t verticals = photometry.vertical_deg.size();
    const auto differs = [](double announced, std::size_t found) {
        return announced != 0.0 && announced != static_cast<double>(found);
    };
    std::stable_sort(readings.begin(), readings.end(), [](const Reading& a, const Reading& b) {
        return std::pair{a.horizontal_deg, a.vertical_deg} < std::pair{b.horizontal_deg, b.vertical_deg};
    });
    bool grid = readings.size() / horizontals == verticals && readings.size() % horizontals == 0;
    std::vector<double> figures;
    for (std::size_t k = 0; grid && k < readings.size(); ++k) {
        grid = readings[k].vertical_deg == photometry.vertical_deg[k % verticals];
        figures.push_back(readings[k].figure);
    }
    if (!grid) {
        findings.fault(gathered.first_line, "IntData",
                       fmt::format("{} values at {} horizontal and {} vertical angles form no grid", readings.size(),
                                   horizontals, verticals));
    } else if (differs(gathered.announced_horizontals, horizontals) ||
               differs(gathered.announced_verticals, verticals)) {
        findings.fault(gathered.first_line, "NumberMeasured",
                       fmt::format("{} x {} angles announced, {} x {} found", gathered.announced_horizontals,
                                   gathered.announced_verticals, horizontals, verticals));
    }
    return figures;
}

void set_opening(const Gathered& gathered, int line, Photometry& photometry, LuminaireFindings& findings) {
    if (gathered.areas != 1 || !(gathered.area_length > 0.0)) {
        if (gathered.areas > 0) findings.warn(line, "EmissionAreas", "more than one area below; read as a point");
        return;
    }
    const bool turned = gathered.length_along_90;
    photometry.opening = {gathered.area_round ? OpeningShape::circle : OpeningShape::rectangle,
                          turned ? gathered.area_width : gathered.area_length,
                          turned ? gathered.area_length : gathered.area_width, 0.0};
    if (gathered.area_round) photometry.opening.extent_0 = photometry.opening.extent_90 = gathered.area_length;
    check_opening(photometry.opening, line, findings);
}

/// What keeps gathered figures from being a luminaire's candela.
bool refuse(const Gathered& gathered, LuminaireFindings& findings) {
    if (findings.failed()) return true;
    const int line = gathered.root_line;
    if (gathered.readings.empty() && !gathered.root.starts_with("IESTM33")) {
        findings.fault(line, "root", in_quotes("<" + gathered.root + ">") + " found; TM-33 files begin with <IESTM33>");
    } else if (gathered.readings.empty()) {
        findings.fault(line, "LuminousData",
                       gathered.other_quantity ? "the file holds radiant or photon intensity, no luminous intensity"
                                               : "the file holds no luminous intensity");
    } else if (gathered.emitters > 1) {
        findings.fault(line, "Emitter",
                       fmt::format("{} emitters found; files of one emitter are read", gathered.emitters));
    } else if (gathered.relative) {
        findings.fault(line, "AbsolutePhotometry", "false or 0 found; only absolute photometry is read");
    } else if (gathered.multiplier < 0.0) {
        findings.fault(line, "Multiplier", fmt::format("{} found, allowed is 0 or more", gathered.multiplier));
    }
    return findings.failed();
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

}  // namespace

Photometry read_tm33(std::string_view text, LuminaireFindings& findings) {
    Photometry photometry;
    photometry.format = "TM-33";
    photometry.absolute = true;
    Gathered gathered;
    for_each_element(text, findings, [&](const XmlElement& xml) {
        read_header(xml, photometry, gathered);
        read_emitter_figures(xml, photometry, gathered, findings);
        read_area(xml, gathered, findings);
    });
    if (refuse(gathered, findings)) return photometry;
    std::vector<double> figures = arrange(gathered, photometry, findings);
    const int line = gathered.first_line;
    check_vertical(photometry, line, findings);
    if (findings.failed()) return photometry;
    const auto symmetry = symmetry_of(photometry.type, photometry.horizontal_deg, line, findings);
    if (!symmetry) return photometry;
    photometry.symmetry = *symmetry;
    set_candela(photometry, std::move(figures), gathered.multiplier, line, findings);
    set_opening(gathered, line, photometry, findings);
    return photometry;
}

bool looks_like_tm33(std::string_view text) {
    text = trimmed(text);
    return text.starts_with("<?xml") || (text.starts_with('<') && text.find("<IESTM33") != std::string_view::npos);
}

}  // namespace hanei
