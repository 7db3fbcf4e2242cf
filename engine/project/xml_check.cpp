#include "engine/project/xml_check.h"

#include "engine/project/number_text.h"

#include <array>
#include <charconv>
#include <fmt/format.h>
#include <set>
#include <string>
#include <system_error>
#include <utility>

namespace hanei {
namespace {

constexpr int deepest = 64;                // photometric files nest six deep
constexpr std::size_t longest_name = 128;  // bytes: four times the longest of TM-33

/// One of XML's own five names, or the number of a character that a text can hold.
bool is_own_reference(std::string_view name) {
    constexpr std::array<std::string_view, 5> names{"lt", "gt", "amp", "quot", "apos"};
    for (const std::string_view own : names) {
        if (name == own) return true;
    }
    if (!name.starts_with('#')) return false;
    name.remove_prefix(1);
    const int base = name.starts_with('x') ? 16 : 10;
    if (base == 16) name.remove_prefix(1);
    unsigned code = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), code, base);
    const bool printable = code >= ' ' || code == '\t' || code == '\n' || code == '\r';
    return error == std::errc{} && end == name.data() + name.size() && printable && code <= 0x10FFFF;
}

class Check : public pugi::xml_tree_walker {
public:
    Check(std::string_view text, LuminaireFindings& findings) : text_(text), lines_(text), findings_(findings) {}

    bool for_each(pugi::xml_node& node) override {
        if (node.type() == pugi::node_doctype) refuse_document_type(text_, node.offset_debug(), findings_);
        if (node.type() == pugi::node_element) check_element(node);
        if (node.type() == pugi::node_pcdata) check_references(node, node.value());
        return !findings_.failed();
    }

    bool references() const { return references_; }

private:
    void fault(const pugi::xml_node& node, const char* field, std::string message) {
        findings_.fault(lines_.at(node.offset_debug()), field, std::move(message));
    }

    void check_element(const pugi::xml_node& element) {
        if (depth() >= deepest)
            return fault(element, "nesting", fmt::format("elements stand more than {} deep in one another", deepest));
        if (depth() == 0 && root_seen_) return fault(element, "root", "a second root element; a file has one");
        root_seen_ = true;
        check_name(element, element.name());
        std::set<std::string_view> names;
        for (const pugi::xml_attribute& attribute : element.attributes()) {
            check_name(element, attribute.name());
            check_references(element, attribute.value());
            if (!names.insert(attribute.name()).second)
                fault(element, "xml", fmt::format("the attribute {} stands twice", in_quotes(attribute.name())));
        }
    }

    void check_name(const pugi::xml_node& node, std::string_view name) {
        if (name.size() <= longest_name) return;
        fault(node, "xml", fmt::format("{}: a name has {} bytes at most", in_quotes(name), longest_name));
    }

    void check_references(const pugi::xml_node& node, std::string_view value) {
        for (std::size_t k = value.find('&'); k != std::string_view::npos; k = value.find('&', k + 1)) {
            references_ = true;
            const std::size_t end = value.find(';', k);
            const std::string_view name = value.substr(k + 1, end == std::string_view::npos ? end : end - k - 1);
            if (end == std::string_view::npos || !is_own_reference(name))
                return fault(node, "xml",
                             fmt::format("{}: entities of a file's own are not allowed",
                                         in_quotes(value.substr(k, name.size() + 2))));
        }
    }

    std::string_view text_;
    XmlLines lines_;
    LuminaireFindings& findings_;
    bool root_seen_ = false;
    bool references_ = false;
};

}  // namespace

bool check_elements(pugi::xml_document& document, std::string_view text, LuminaireFindings& findings) {
    Check check{text, findings};
    document.traverse(check);
    return check.references();
}

void refuse_document_type(std::string_view text, std::ptrdiff_t offset, LuminaireFindings& findings) {
    findings.fault(XmlLines{text}.at(offset), "DOCTYPE", "document types and entities are not allowed");
}

}  // namespace hanei
