#include "engine/project/json_text.h"

#include <algorithm>

namespace hanei {
namespace {

constexpr std::size_t width = 120;

bool is_container(const JsonValue& value) {
    return value.is(JsonValue::Kind::list) || value.is(JsonValue::Kind::object);
}

std::string prefix_of(const JsonValue& parent, std::size_t item) {
    return parent.is(JsonValue::Kind::object) ? json_quoted(parent.keys[item]) + ": " : std::string();
}

void write_opened(const JsonValue& value, std::size_t indent, std::size_t taken, std::string& text);

/// Scalars one after another, broken where the line is full.
void write_filled(const JsonValue& list, std::size_t indent, std::string& text) {
    std::size_t column = width;
    for (std::size_t i = 0; i < list.items.size(); ++i) {
        const std::string item = one_line(list.items[i]) + (i + 1 < list.items.size() ? "," : "");
        const bool breaks = column + 1 + item.size() > width;
        text += breaks ? '\n' + std::string(indent, ' ') : std::string(" ");
        column = (breaks ? indent : column + 1) + item.size();
        text += item;
    }
}

/// `taken`: characters already on the line.
void write(const JsonValue& value, std::size_t indent, std::size_t taken, std::string& text) {
    const std::string line = one_line(value);
    if (!is_container(value) || taken + line.size() + 1 <= width) {
        text += line;
        return;
    }
    write_opened(value, indent, taken, text);
}

void write_opened(const JsonValue& value, std::size_t indent, std::size_t, std::string& text) {
    const bool list = value.is(JsonValue::Kind::list);
    text += list ? '[' : '{';
    if (list && std::none_of(value.items.begin(), value.items.end(), is_container)) {
        write_filled(value, indent + 2, text);
    } else {
        for (std::size_t i = 0; i < value.items.size(); ++i) {
            const std::string prefix = prefix_of(value, i);
            text += '\n' + std::string(indent + 2, ' ') + prefix;
            write(value.items[i], indent + 2, indent + 2 + prefix.size(), text);
            if (i + 1 < value.items.size()) text += ',';
        }
    }
    text += '\n' + std::string(indent, ' ') + (list ? ']' : '}');
}

}  // namespace

std::string one_line(const JsonValue& value) {
    switch (value.kind) {
        case JsonValue::Kind::null:
            return "null";
        case JsonValue::Kind::boolean:
            return value.truth ? "true" : "false";
        case JsonValue::Kind::number:
            return value.text;
        case JsonValue::Kind::text:
            return json_quoted(value.text);
        case JsonValue::Kind::list:
        case JsonValue::Kind::object:
            break;
    }
    const bool list = value.is(JsonValue::Kind::list);
    std::string text = list ? "[" : "{";
    for (std::size_t i = 0; i < value.items.size(); ++i)
        text += (i == 0 ? "" : ", ") + prefix_of(value, i) + one_line(value.items[i]);
    return text + (list ? ']' : '}');
}

std::string json_document(const JsonValue& value) {
    std::string text;
    if (is_container(value) && !value.items.empty())
        write_opened(value, 0, 0, text);
    else
        text = one_line(value);
    return text + '\n';
}

}  // namespace hanei
