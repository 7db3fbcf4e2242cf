#include "engine/project/json_fields.h"

#include "engine/project/json_text.h"
#include "engine/project/text_file.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hanei {

void JsonReading::error(const JsonValue& at, const std::string& path, const std::string& message) {
    findings.push_back(about_file(Severity::error, file, at.line, path, message));
}

void JsonReading::warn(const JsonValue& at, const std::string& path, const std::string& message) {
    findings.push_back(about_file(Severity::warning, file, at.line, path, message));
}

std::string described(const JsonValue& value) {
    constexpr std::size_t longest = 40;
    switch (value.kind) {
        case JsonValue::Kind::list:
            return "a list of " + std::to_string(value.items.size());
        case JsonValue::Kind::object:
            return "an object";
        case JsonValue::Kind::text:
            return json_quoted(value.text.size() <= longest ? value.text : value.text.substr(0, longest) + "...");
        case JsonValue::Kind::null:
        case JsonValue::Kind::boolean:
        case JsonValue::Kind::number:
            break;
    }
    return one_line(value);
}

namespace {

bool refuse(JsonReading& reading, const JsonValue& value, const std::string& path, std::string_view expected) {
    reading.error(value, path, "found " + described(value) + ", expected " + std::string(expected));
    return false;
}

template <class Vector>
bool take_vector(JsonReading& reading, const JsonValue& value, const std::string& path, std::string_view expected,
                 Vector& target) {
    if (!value.is(JsonValue::Kind::list) || value.items.size() != static_cast<std::size_t>(Vector::length()))
        return refuse(reading, value, path, expected);
    Vector vector;
    for (glm::length_t i = 0; i < Vector::length(); ++i)
        if (!take_value(reading, value.items[static_cast<std::size_t>(i)], path + '[' + std::to_string(i) + ']',
                        vector[i]))
            return false;
    target = vector;
    return true;
}

}  // namespace

bool take_value(JsonReading& reading, const JsonValue& value, const std::string& path, double& target) {
    if (!value.is(JsonValue::Kind::number)) return refuse(reading, value, path, "a number");
    target = value.number;
    return true;
}

bool take_value(JsonReading& reading, const JsonValue& value, const std::string& path, int& target) {
    const bool whole = value.is(JsonValue::Kind::number) && value.number == std::floor(value.number) &&
                       std::abs(value.number) <= std::numeric_limits<int>::max();
    if (!whole) return refuse(reading, value, path, "a whole number");
    target = static_cast<int>(value.number);
    return true;
}

bool take_value(JsonReading& reading, const JsonValue& value, const std::string& path, bool& target) {
    if (!value.is(JsonValue::Kind::boolean)) return refuse(reading, value, path, "true or false");
    target = value.truth;
    return true;
}

bool take_value(JsonReading& reading, const JsonValue& value, const std::string& path, std::string& target) {
    if (!value.is(JsonValue::Kind::text)) return refuse(reading, value, path, "a text");
    target = value.text;
    return true;
}

bool take_value(JsonReading& reading, const JsonValue& value, const std::string& path, Vec2& target) {
    return take_vector(reading, value, path, "two numbers [x, y]", target);
}

bool take_value(JsonReading& reading, const JsonValue& value, const std::string& path, Vec3& target) {
    return take_vector(reading, value, path, "three numbers [x, y, z]", target);
}

bool take_list(JsonReading& reading, const JsonValue& value, const std::string& path) {
    return value.is(JsonValue::Kind::list) || refuse(reading, value, path, "a list");
}

Fields::Fields(JsonReading& reading, const JsonValue& value, std::string path)
    : reading_(reading), value_(value), path_(std::move(path)) {
    if (!value.is(JsonValue::Kind::object)) refuse(reading, value, path_, "an object {...}");
}

std::string Fields::path_of(std::string_view key) const {
    return path_.empty() ? std::string(key) : path_ + '.' + std::string(key);
}

const JsonValue* Fields::take(std::string_view key) {
    taken_.emplace_back(key);
    return value_.find(key);
}

void Fields::optional_scaled(std::string_view key, FileUnit unit, double& target) {
    double shown = 0.0;
    if (optional(key, shown)) target = scaled(*value_.find(key), unit);
}

void Fields::missing(std::string_view key, std::string_view expected) {
    if (!value_.is(JsonValue::Kind::object)) return;
    reading_.error(value_, path_of(key), "the field is missing; expected " + std::string(expected));
}

void Fields::error(std::string_view key, const std::string& message) {
    const JsonValue* const value = value_.find(key);
    reading_.error(value == nullptr ? value_ : *value, path_of(key), message);
}

JsonValue Fields::unknown_object(const char* consequence) {
    JsonValue rest = json_object();
    for (std::size_t i = 0; i < value_.keys.size(); ++i) {
        const std::string& key = value_.keys[i];
        if (std::find(taken_.begin(), taken_.end(), key) != taken_.end()) continue;
        reading_.warn(value_.items[i], path_of(key),
                      "this version does not know the field; " + std::string(consequence));
        rest.add(key, value_.items[i]);
    }
    return rest;
}

std::string Fields::unknown() {
    const JsonValue rest = unknown_object();
    return rest.items.empty() ? std::string() : one_line(rest);
}

}  // namespace hanei
