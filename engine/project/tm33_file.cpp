#include "engine/project/tm33_file.h"

#include "engine/project/luminaire_text.h"
#include "engine/project/number_text.h"
#include "engine/project/photometric_sum.h"
#include "engine/project/photometric_table.h"
#include "engine/project/tm33_emitter.h"
#include "engine/project/xml_elements.h"

#include <algorithm>
#include <fmt/format.h>
#include <string>
#include <utility>

namespace hanei {
namespace {

bool is_known_root(std::string_view name) {
    return name.starts_with("IESTM33") || name.starts_with("ATLA_S001") || name == "LuminaireOpticalData";
}

struct Goniometer {
    PhotometricType type = PhotometricType::C;
    bool length_along_90 = false;
};

/// "IES_C", "CIE _ C", "Type C": the last letter is the type.
Goniometer goniometer_of(const pugi::xml_node& root) {
    const pugi::xml_node equipment = root.child("Equipment");
    std::string word = xml_text(equipment.child("Gonioradiometer").child("Type"));
    if (word.empty()) word = xml_text(equipment.child("Goniometer").child("GoniometerType"));
    Goniometer goniometer;
    if (word.ends_with('A')) goniometer.type = PhotometricType::A;
    if (word.ends_with('B')) goniometer.type = PhotometricType::B;
    goniometer.length_along_90 = word.starts_with("CIE");
    return goniometer;
}

Photometry header_of(const pugi::xml_node& root) {
    Photometry photometry;
    const std::string version = xml_text(root.child("Version"));
    photometry.format = "TM-33";
    if (!version.empty()) photometry.format += ' ' + version;
    for (const pugi::xml_node& field : root.child("Header")) {
        if (field.type() == pugi::node_element) photometry.keywords.emplace_back(field.name(), xml_text(field));
    }
    photometry.name = xml_text(root.child("Header").child("Description"));
    return photometry;
}

/// The header's words around an emitter's figures.
Photometry with_header(const Photometry& header, Photometry figures) {
    figures.format = header.format;
    figures.keywords.insert(figures.keywords.begin(), header.keywords.begin(), header.keywords.end());
    figures.name = header.name;
    return figures;
}

void refuse_without_intensity(const pugi::xml_node& root, int line, LuminaireFindings& findings) {
    if (!is_known_root(root.name())) {
        return findings.fault(line, "root",
                              in_quotes(fmt::format("<{}>", root.name())) + " found; TM-33 files begin with <IESTM33>");
    }
    const auto emitters = root.children("Emitter");
    const bool other = std::any_of(emitters.begin(), emitters.end(), [](const pugi::xml_node& emitter) {
        return emitter.child("RadiantData") || emitter.child("PhotonData");
    });
    findings.fault(line, "LuminousData",
                   other ? "the file holds radiant or photon intensity, no luminous intensity"
                         : "the file holds no luminous intensity");
}

std::vector<Tm33Emitter> emitters_of(std::string_view text, const pugi::xml_node& root, PhotometricType type, int line,
                                     LuminaireFindings& findings) {
    std::vector<Tm33Emitter> emitters;
    std::size_t dark = 0;
    for (const pugi::xml_node& node : root.children("Emitter")) {
        std::optional<Tm33Emitter> emitter = read_tm33_emitter(text, node, type, findings);
        if (findings.failed()) return {};
        if (emitter)
            emitters.push_back(std::move(*emitter));
        else
            ++dark;
    }
    if (emitters.empty())
        refuse_without_intensity(root, line, findings);
    else if (dark > 0)
        findings.warn(line, "Emitter", fmt::format("{} emitters without luminous intensity are left out", dark));
    return emitters;
}

/// The declared flux of all, where every one declares its own; the report compares it (photometry_figures.h).
void declare_flux(const std::vector<Tm33Emitter>& emitters, Photometry& photometry) {
    double total = 0.0;
    for (const Tm33Emitter& emitter : emitters) {
        if (!emitter.declared_flux) return;
        total += *emitter.declared_flux;
    }
    if (total > 0.0) photometry.keywords.emplace_back("LuminousFlux", fmt::format("{}", total));
}

std::optional<Photometry> summed(const std::vector<Tm33Emitter>& emitters, const Goniometer& goniometer, int line,
                                 LuminaireFindings& findings) {
    std::vector<Photometry> parts;
    std::vector<Tm33Area> areas;
    bool known = true, off_centre = false;
    for (const Tm33Emitter& emitter : emitters) {
        parts.push_back(emitter.photometry);
        areas.insert(areas.end(), emitter.areas.begin(), emitter.areas.end());
        known = known && emitter.known;
        off_centre = off_centre || emitter.has_centre;
    }
    if (!known && emitters.size() > 1) return std::nullopt;
    std::optional<Photometry> sum = photometric_sum(parts);
    if (!sum) return std::nullopt;
    if (emitters.size() > 1) {
        sum->lamp_sets.clear();  // lamps of the parts together are no alternatives
        findings.warn(line, "Emitter",
                      fmt::format("the intensities of {} emitters are added{}", emitters.size(),
                                  off_centre ? ", as if they lay in one place" : ""));
    }
    sum->opening = tm33_opening(areas, goniometer.length_along_90, emitters.front().line, findings);
    check_opening(sum->opening, emitters.front().line, findings);
    declare_flux(emitters, *sum);
    return sum;
}

std::vector<Photometry> separate(const std::vector<Tm33Emitter>& emitters, const Goniometer& goniometer, int line,
                                 LuminaireFindings& findings) {
    std::vector<Photometry> photometries;
    for (const Tm33Emitter& emitter : emitters) {
        Photometry& photometry = photometries.emplace_back(emitter.photometry);
        photometry.opening = tm33_opening(emitter.areas, goniometer.length_along_90, emitter.line, findings);
        check_opening(photometry.opening, emitter.line, findings);
        declare_flux({emitter}, photometry);
    }
    findings.warn(
        line, "Emitter",
        fmt::format("the intensities of {} emitters cannot be added; each is a luminaire of its own", emitters.size()));
    return photometries;
}

}  // namespace

std::vector<Photometry> read_tm33(std::string_view text, LuminaireFindings& findings) {
    pugi::xml_document document;
    if (!parse_xml(text, document, findings)) return {};
    const pugi::xml_node root = document.document_element();
    const int line = xml_line(text, root);
    const Goniometer goniometer = goniometer_of(root);
    const std::vector<Tm33Emitter> emitters = emitters_of(text, root, goniometer.type, line, findings);
    if (findings.failed()) return {};
    const Photometry header = header_of(root);
    if (std::optional<Photometry> sum = summed(emitters, goniometer, line, findings)) {
        Photometry whole = with_header(header, std::move(*sum));
        return {std::move(whole)};
    }
    std::vector<Photometry> photometries = separate(emitters, goniometer, line, findings);
    for (std::size_t k = 0; k < photometries.size(); ++k) {
        photometries[k] = with_header(header, std::move(photometries[k]));
        const std::string& part = emitters[k].name;
        photometries[k].name += " / " + (part.empty() ? fmt::format("emitter {}", k + 1) : part);
    }
    return photometries;
}

bool looks_like_tm33(std::string_view text) {
    text = trimmed(text);
    if (text.starts_with("<?xml")) return true;
    if (!text.starts_with('<')) return false;
    for (const char* root : {"<IESTM33", "<ATLA_S001", "<LuminaireOpticalData"}) {
        if (text.find(root) != std::string_view::npos) return true;
    }
    return false;
}

}  // namespace hanei
