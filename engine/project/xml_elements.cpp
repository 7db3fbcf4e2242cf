#include "engine/project/xml_elements.h"

#include "engine/project/luminaire_text.h"
#include "engine/project/number_text.h"
#include "engine/project/xml_check.h"

#include <algorithm>
#include <cstddef>

namespace hanei {
namespace {

/// References stay as they are written until they are found to be XML's own.
constexpr unsigned as_written = (pugi::parse_default & ~pugi::parse_escapes) | pugi::parse_ws_pcdata;

const char* sentence_of(const pugi::xml_parse_result& result) {
    switch (result.status) {
        case pugi::status_end_element_mismatch:
            return "the end tag of an open element is missing here";
        case pugi::status_bad_end_element:
            return "an end tag holds its element's name alone";
        case pugi::status_bad_start_element:
            return "a start tag does not end or goes on after its attributes";
        case pugi::status_bad_attribute:
            return "an attribute is a name, =, and a value in quotes";
        case pugi::status_bad_comment:
            return "the comment does not end";
        case pugi::status_bad_cdata:
            return "the text section does not end";
        case pugi::status_bad_pi:
            return "the instruction does not end";
        case pugi::status_unrecognized_tag:
            return "no tag of XML begins so";
        case pugi::status_no_document_element:
            return "the file holds no element";
        default:
            return result.description();
    }
}

void refuse_damaged(const pugi::xml_parse_result& result, std::string_view text, LuminaireFindings& findings) {
    if (result.status == pugi::status_bad_doctype) return refuse_document_type(text, result.offset, findings);
    const int line = XmlLines{text}.at(result.offset);
    const auto offset = static_cast<std::size_t>(result.offset);
    const std::size_t tag = text.rfind('<', offset);
    const std::size_t begin = tag == std::string_view::npos ? 0 : tag;
    const std::size_t end = std::min(text.find('>', begin), text.size() - 1);
    findings.fault(line, "xml", in_quotes(text.substr(begin, end + 1 - begin)) + ": " + sentence_of(result));
}

}  // namespace

bool parse_xml(std::string_view text, pugi::xml_document& document, LuminaireFindings& findings) {
    const auto parse = [&](unsigned options) {
        return document.load_buffer(text.data(), text.size(), options, pugi::encoding_utf8);
    };
    pugi::xml_parse_result result = parse(as_written | pugi::parse_doctype);
    const bool references = check_elements(document, text, findings);
    if (!findings.failed() && result && references) result = parse(as_written | pugi::parse_escapes);
    if (!findings.failed() && !result) refuse_damaged(result, text, findings);
    return !findings.failed();
}

std::string xml_text(const pugi::xml_node& element) {
    std::string text;
    for (const pugi::xml_node& piece : element) {  // comments and child elements part a text into pieces
        if (piece.type() == pugi::node_pcdata || piece.type() == pugi::node_cdata) text += piece.value();
    }
    return utf8_text(trimmed(text));
}

int xml_line(std::string_view text, const pugi::xml_node& element) { return XmlLines{text}.at(element.offset_debug()); }

}  // namespace hanei
