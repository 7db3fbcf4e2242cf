/// XML as photometric files have it, parsed by pugixml.
#pragma once

#include "engine/project/luminaire_findings.h"

#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace hanei {

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

}  // namespace hanei
