/// The elements of an XML file one after another, parsed by pugixml.
#pragma once

#include "engine/project/luminaire_findings.h"

#include <functional>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace hanei {

/// An element as it stands in its file.
struct XmlElement {
    std::string path;     ///< "IESTM33/Header/Manufacturer"
    std::string text;     ///< its own, without blanks at both ends
    int line = 0;         ///< of its start tag
    pugi::xml_node node;  ///< valid during the visit

    std::optional<std::string_view> attribute(const char* name) const;
};

/// The document of a text that is well formed and asks for nothing photometric files do not: a document
/// type, an entity of its own, nesting or names beyond any of theirs are faults.
///
/// Needs     text without NUL bytes. Its encoding is taken as UTF-8 whatever the file declares.
/// Cost      linear in the text; up to 22 bytes of memory for each of its bytes while it is read.
bool parse_xml(std::string_view text, pugi::xml_document& document, LuminaireFindings& findings);

/// An element's own text, without blanks at both ends; bytes that are not UTF-8 are read as Latin-1.
std::string xml_text(const pugi::xml_node& element);

/// The line of an element's start tag. Cost: linear in the text.
int xml_line(std::string_view text, const pugi::xml_node& element);

using XmlVisit = std::function<void(const XmlElement&)>;

/// Visits every element in the order of the file, a parent before its children, until a fault is found.
/// None is visited in a file that parse_xml refuses.
///
/// Needs     what parse_xml needs.
/// Returns   paths and texts in UTF-8; bytes that are not are read as Latin-1.
void for_each_element(std::string_view text, LuminaireFindings& findings, const XmlVisit& visit);

}  // namespace hanei
