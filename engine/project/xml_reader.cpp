#include "engine/project/xml_reader.h"

#include "engine/project/luminaire_text.h"
#include "engine/project/number_text.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

namespace hanei {
namespace {

constexpr std::size_t deepest = 64;  // photometric files nest six deep

std::optional<char> named_entity(std::string_view name) {
    if (name == "lt") return '<';
    if (name == "gt") return '>';
    if (name == "amp") return '&';
    if (name == "quot") return '"';
    if (name == "apos") return '\'';
    return std::nullopt;
}

}  // namespace

bool XmlReader::fail(std::string_view message) {
    findings_.fault(line_, "xml", std::string{message});
    return false;
}

void XmlReader::advance(std::size_t count) {
    line_ += static_cast<int>(std::count(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(count), '\n'));
    rest_.remove_prefix(count);
}

bool XmlReader::skip_past(std::string_view end, std::string_view what) {
    const std::size_t found = rest_.find(end);
    if (found == std::string_view::npos) return fail(what);
    advance(found + end.size());
    return true;
}

/// Numbered characters beyond ASCII stand in texts only and are left as they are written.
void XmlReader::append_decoded(std::string& to, std::string_view raw) {
    while (!raw.empty()) {
        const std::size_t ampersand = raw.find('&');
        to += raw.substr(0, ampersand);
        if (ampersand == std::string_view::npos) return;
        raw.remove_prefix(ampersand);
        const std::size_t end = raw.find(';');
        const std::string_view name = raw.substr(1, end == std::string_view::npos ? 0 : end - 1);
        if (const auto character = named_entity(name)) {
            to += *character;
        } else if (name.starts_with('#')) {
            to += raw.substr(0, end + 1);
        } else {
            fail("entities of a file's own are not allowed");
            return;
        }
        raw.remove_prefix(end + 1);
    }
}

bool XmlReader::read_attributes(Element& element, std::string_view inside) {
    while (!(inside = trimmed(inside)).empty()) {
        const std::size_t equals = inside.find('=');
        if (equals == std::string_view::npos) return fail("an attribute has no value");
        const std::string_view name = trimmed(inside.substr(0, equals));
        inside = trimmed(inside.substr(equals + 1));
        if (inside.empty() || (inside[0] != '"' && inside[0] != '\'')) return fail("an attribute's value needs quotes");
        const std::size_t end = inside.find(inside[0], 1);
        if (end == std::string_view::npos) return fail("an attribute's value does not end");
        std::string value;
        append_decoded(value, inside.substr(1, end - 1));
        element.attributes.emplace_back(name, std::move(value));
        inside.remove_prefix(end + 1);
    }
    return !findings_.failed();
}

bool XmlReader::read_start_tag() {
    const std::size_t end = rest_.find('>');
    if (end == std::string_view::npos) return fail("a tag does not end");
    std::string_view inside = rest_.substr(1, end - 1);
    const bool empty = inside.ends_with('/');
    if (empty) inside.remove_suffix(1);
    Element element;
    const std::size_t blank = std::min(inside.find_first_of(" \t\r\n"), inside.size());
    element.name = inside.substr(0, blank);
    if (element.name.empty()) return fail("a tag has no name");
    if (!read_attributes(element, inside.substr(blank))) return false;
    if (open_.size() == deepest) return fail("elements are nested deeper than in any photometric file");
    open_.push_back(std::move(element));
    if (!path_.empty()) path_ += '/';
    path_ += open_.back().name;
    advance(end + 1);
    element_ended_ = empty;
    return true;
}

bool XmlReader::read_end_tag() {
    const std::size_t end = rest_.find('>');
    if (end == std::string_view::npos) return fail("a tag does not end");
    const std::string_view name = trimmed(rest_.substr(2, end - 2));
    if (open_.empty() || open_.back().name != name)
        return fail(fmt::format("</{}> ends what it did not begin", utf8_text(name)));
    advance(end + 1);
    element_ended_ = true;
    return true;
}

bool XmlReader::read_markup() {
    if (rest_.starts_with("<?")) return skip_past("?>", "an instruction does not end");
    if (rest_.starts_with("<!--")) return skip_past("-->", "a comment does not end");
    if (rest_.starts_with("<![CDATA[") && !open_.empty()) {
        const std::size_t end = rest_.find("]]>");
        if (end != std::string_view::npos) open_.back().text += rest_.substr(9, end - 9);
        return skip_past("]]>", "a text section does not end");
    }
    if (rest_.starts_with("<!")) return fail("document types and entities are not allowed");
    return rest_.starts_with("</") ? read_end_tag() : read_start_tag();
}

void XmlReader::close() {
    ended_ = std::move(open_.back());
    open_.pop_back();
    ended_.text = std::string{trimmed(ended_.text)};
    root_ended_ = open_.empty();
}

bool XmlReader::next() {
    if (element_ended_) path_.resize(path_.size() - std::min(path_.size(), ended_.name.size() + 1));
    element_ended_ = false;
    while (!findings_.failed() && !root_ended_) {
        const std::size_t tag = rest_.find('<');
        if (tag == std::string_view::npos) return fail("the file ends inside an element");
        if (!open_.empty()) append_decoded(open_.back().text, rest_.substr(0, tag));
        advance(tag);
        if (!read_markup()) return false;
        if (!element_ended_) continue;
        close();
        return true;
    }
    return false;
}

const std::string* XmlReader::attribute(std::string_view name) const {
    for (const auto& [key, value] : ended_.attributes) {
        if (key == name) return &value;
    }
    return nullptr;
}

}  // namespace hanei
