/// What a parsed XML document may hold to be read as a photometric file.
#pragma once

#include "engine/project/luminaire_findings.h"
#include "engine/project/luminaire_text.h"

#include <cstddef>
#include <pugixml.hpp>
#include <string_view>

namespace hanei {

/// Lines of places in a text, asked for from its beginning to its end.
class XmlLines {
public:
    explicit XmlLines(std::string_view text) : text_(text), lines_(text) {}

    int at(std::ptrdiff_t offset) {
        while (!lines_.rest().empty() && lines_.rest().data() - text_.data() <= offset) lines_.next();
        return lines_.number();
    }

private:
    std::string_view text_;
    LineReader lines_;
};

/// A fault for the first thing in the document that no photometric file holds: a document type, a second
/// root, an entity of the file's own, an attribute twice, nesting or names beyond reason.
///
/// Needs     a document parsed with document types and without decoding references. After a parsing
///           fault its part before the fault is checked.
/// Returns   true when references are to be decoded.
bool check_elements(pugi::xml_document& document, std::string_view text, LuminaireFindings& findings);

void refuse_document_type(std::string_view text, std::ptrdiff_t offset, LuminaireFindings& findings);

}  // namespace hanei
