#include "engine/project/gldf_product.h"

#include "engine/project/luminaire_text.h"
#include "engine/project/number_text.h"
#include "engine/project/xml_elements.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string>

namespace hanei {
namespace {

std::string attribute_of(const pugi::xml_node& node, const char* name) {
    return utf8_text(node.attribute(name).value());
}

std::string child_text(const pugi::xml_node& node, const char* name) { return xml_text(node.child(name)); }

/// Of <Name><Locale language="en">...</Locale></Name>; a plain text stands for itself.
std::string in_english(const pugi::xml_node& element) {
    if (!element.child("Locale")) return xml_text(element);
    for (const pugi::xml_node& locale : element.children("Locale")) {
        if (attribute_of(locale, "language").starts_with("en")) return xml_text(locale);
    }
    return xml_text(element.child("Locale"));
}

/// Elements of one name below `node`, in the order of the file.
std::vector<pugi::xml_node> all_below(const pugi::xml_node& node, std::string_view name) {
    std::vector<pugi::xml_node> found;
    struct Walker : pugi::xml_tree_walker {
        std::string_view wanted;
        std::vector<pugi::xml_node>* nodes = nullptr;
        bool for_each(pugi::xml_node& element) override {
            if (element.name() == wanted) nodes->push_back(element);
            return true;
        }
    } walker;
    walker.wanted = name;
    walker.nodes = &found;
    pugi::xml_node start = node;
    start.traverse(walker);
    return found;
}

/// A number of the product; a text that is none says so and counts as absent.
class Numbers {
public:
    Numbers(std::string_view text, LuminaireFindings& findings) : text_(text), findings_(findings) {}

    std::optional<double> of(const pugi::xml_node& node, const char* name) {
        const pugi::xml_node element = node.child(name);
        if (!element) return std::nullopt;
        const std::string text = xml_text(element);
        const std::optional<double> value = decimal_number(text);
        if (value && *value >= 0.0) return value;
        warn(element, name, text);
        return std::nullopt;
    }

    double angle(const pugi::xml_node& node, const char* name) {
        const pugi::xml_node element = node.child(name);
        if (!element) return 0.0;
        const std::optional<double> value = decimal_number(xml_text(element));
        if (!value) warn(element, name, xml_text(element));
        return value.value_or(0.0);
    }

private:
    void warn(const pugi::xml_node& element, const char* name, const std::string& text) {
        constexpr int most = 20;  // what a reader takes in; more would only repeat it
        if (++warned_ > most) return;
        findings_.warn(xml_line(text_, element), name,
                       in_quotes(text) + " is no figure that can be used; it is left out");
    }

    std::string_view text_;
    LuminaireFindings& findings_;
    int warned_ = 0;
};

struct LightSources {
    std::map<std::string, pugi::xml_node> sources, equipments;
};

LightSources light_sources(const pugi::xml_node& definitions) {
    LightSources all;
    for (const pugi::xml_node& source : definitions.child("LightSources")) {
        if (source.type() != pugi::node_element) continue;
        all.sources.emplace(attribute_of(source, "id"), source);
    }
    for (const pugi::xml_node& equipment : definitions.child("Equipments").children("Equipment"))
        all.equipments.emplace(attribute_of(equipment, "id"), equipment);
    return all;
}

pugi::xml_node source_of(const LightSources& all, const pugi::xml_node& node) {
    const pugi::xml_node reference = node.child("LightSourceReference");
    for (const char* name :
         {"fixedLightSourceId", "changeableLightSourceId", "multiChannelLightSourceId", "lightSourceId"}) {
        const auto found = all.sources.find(attribute_of(reference, name));
        if (reference.attribute(name) && found != all.sources.end()) return found->second;
    }
    return {};
}

void add_equipment(const LightSources& all, Numbers& numbers, const pugi::xml_node& node, GldfEmitter& emitter) {
    const auto found = all.equipments.find(attribute_of(node.child("EquipmentReference"), "equipmentId"));
    if (found == all.equipments.end()) return;
    const pugi::xml_node equipment = found->second;
    const pugi::xml_node colour = source_of(all, equipment).child("ColorInformation");
    if (colour) emitter.colour_temperature = numbers.of(colour, "CorrelatedColorTemperature");
    emitter.input_watts = numbers.of(equipment, "RatedInputPower");
    emitter.lamp_flux = numbers.of(equipment, "RatedLuminousFlux");
    if (emitter.lamp_flux) return;
    emitter.lamp_flux = numbers.of(source_of(all, equipment), "RatedLuminousFlux");
    const pugi::xml_node reference = equipment.child("LightSourceReference");
    for (const char* name : {"changeableLightSourceCount", "lightSourceCount"}) {
        const std::optional<double> count = decimal_number(attribute_of(reference, name));
        if (count && emitter.lamp_flux) *emitter.lamp_flux *= *count;
    }
}

void add_rotation(const pugi::xml_node& node, Numbers& numbers, GldfEmitter& emitter) {
    const pugi::xml_node rotation = node.child("Rotation");
    emitter.turn_deg = numbers.angle(rotation, "G0");
    for (const char* axis : {"X", "Y", "Z"}) emitter.tilted = emitter.tilted || numbers.angle(rotation, axis) != 0.0;
}

/// One entry for an emitter's way to operate; for a source of several channels one a channel.
void add_emitters(const std::string& id, const pugi::xml_node& node, const LightSources& all, Numbers& numbers,
                  std::vector<GldfEmitter>& emitters) {
    GldfEmitter emitter;
    emitter.id = id;
    emitter.kind = node.name();
    emitter.name = in_english(node.child("Name"));
    emitter.photometry = attribute_of(node.child("PhotometryReference"), "photometryId");
    emitter.rated_flux = numbers.of(node, "RatedLuminousFlux");
    emitter.emergency = attribute_of(node, "emergencyBehaviour");
    const pugi::xml_node source = source_of(all, node);
    emitter.input_watts = numbers.of(source, "RatedInputPower");
    emitter.colour_temperature = numbers.of(source.child("ColorInformation"), "CorrelatedColorTemperature");
    add_equipment(all, numbers, node, emitter);
    add_rotation(node, numbers, emitter);
    const pugi::xml_node channels = source.child("Channels");
    if (!channels.child("Channel")) return emitters.push_back(std::move(emitter));
    emitter.input_watts.reset();  // stated for all channels together
    for (const pugi::xml_node& channel : channels.children("Channel")) {
        GldfEmitter& one = emitters.emplace_back(emitter);
        const std::string name = in_english(channel.child("DisplayName"));
        one.name = name.empty() ? attribute_of(channel, "type") : name;
        one.photometry = attribute_of(channel.child("PhotometryReference"), "photometryId");
        one.rated_flux = numbers.of(channel, "RatedLuminousFlux");
    }
}

std::string version_of(const pugi::xml_node& version) {
    if (!version.attribute("major")) return xml_text(version);
    std::string text = attribute_of(version, "major") + "." + attribute_of(version, "minor");
    const std::string candidate = attribute_of(version, "pre-release");
    if (!candidate.empty()) text += "-rc." + candidate;
    return text;
}

void add_definitions(const pugi::xml_node& definitions, Numbers& numbers, GldfListing& listing) {
    for (const pugi::xml_node& file : definitions.child("Files").children("File")) {
        listing.files.push_back({attribute_of(file, "id"), attribute_of(file, "contentType"),
                                 attribute_of(file, "type"), xml_text(file), "", false});
    }
    for (const pugi::xml_node& photometry : definitions.child("Photometries").children("Photometry")) {
        listing.photometries.push_back({attribute_of(photometry, "id"),
                                        attribute_of(photometry.child("PhotometryFileReference"), "fileId"),
                                        std::nullopt,
                                        {}});
    }
    const LightSources sources = light_sources(definitions);
    for (const pugi::xml_node& emitter : definitions.child("Emitters").children("Emitter")) {
        for (const pugi::xml_node& way : emitter) {
            if (!std::string_view{way.name()}.ends_with("Emitter")) continue;
            add_emitters(attribute_of(emitter, "id"), way, sources, numbers, listing.emitters);
        }
    }
}

GldfVariant variant_of(const pugi::xml_node& node) {
    GldfVariant variant{attribute_of(node, "id"), in_english(node.child("Name")), {}};
    if (variant.name.empty()) variant.name = in_english(node.child("VariantName"));
    std::set<std::string> known;
    for (const char* name : {"EmitterReference", "SimpleGeometryReference"}) {
        for (const pugi::xml_node& reference : all_below(node, name)) {
            const std::string id = attribute_of(reference, "emitterId");
            if (!id.empty() && known.insert(id).second) variant.emitters.push_back(id);
        }
    }
    return variant;
}

}  // namespace

GldfListing read_gldf_product(std::string_view text, LuminaireFindings& findings) {
    GldfListing listing;
    pugi::xml_document document;
    if (!parse_xml(text, document, findings)) return listing;
    const pugi::xml_node root = document.child("Root");
    if (!root) {
        findings.fault(1, "product.xml", "no element <Root> stands in it; this is no GLDF product");
        return listing;
    }
    Numbers numbers{text, findings};
    const pugi::xml_node header = root.child("Header");
    listing.manufacturer = child_text(header, "Manufacturer");
    listing.format_version = version_of(header.child("FormatVersion"));
    add_definitions(root.child("GeneralDefinitions"), numbers, listing);
    const pugi::xml_node product = root.child("ProductDefinitions");
    listing.product = in_english(product.child("ProductMetaData").child("Name"));
    if (listing.product.empty()) listing.product = in_english(product.child("ProductMetaData").child("ProductName"));
    for (const pugi::xml_node& variant : product.child("Variants").children("Variant"))
        listing.variants.push_back(variant_of(variant));
    return listing;
}

}  // namespace hanei
