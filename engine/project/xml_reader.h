/// Elements of an XML file one after another: no tree, no document types, no entities of its own.
#pragma once

#include "engine/project/luminaire_findings.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hanei {

/// Reports the end of every element with its path, attributes and text. A fault is found where it
/// stands: tags that do not match, nesting deeper than any photometric file's, a document type.
///
/// Needs     UTF-8 text that outlives the reader.
/// Cost      linear in the text; memory for the elements open at a time.
class XmlReader {
public:
    XmlReader(std::string_view text, LuminaireFindings& findings) : rest_(text), findings_(findings) {}

    /// To the end of the next element; false after the root's end or a fault.
    bool next();

    const std::string& path() const { return path_; }  ///< "IESTM33/Header/Manufacturer"
    const std::string& text() const { return ended_.text; }
    const std::string* attribute(std::string_view name) const;  ///< null when there is none
    int line() const { return line_; }

private:
    using Attributes = std::vector<std::pair<std::string_view, std::string>>;
    struct Element {
        std::string_view name;
        Attributes attributes;
        std::string text;
    };

    void advance(std::size_t count);
    bool skip_past(std::string_view end, std::string_view what);
    bool read_markup();
    bool read_start_tag();
    bool read_attributes(Element& element, std::string_view inside);
    bool read_end_tag();
    void close();
    void append_decoded(std::string& to, std::string_view raw);
    bool fail(std::string_view message);

    std::string_view rest_;
    int line_ = 1;
    std::vector<Element> open_;
    Element ended_;
    std::string path_;
    bool element_ended_ = false;
    bool root_ended_ = false;
    LuminaireFindings& findings_;
};

}  // namespace hanei
