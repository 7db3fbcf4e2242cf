/// Taking the fields of a JSON object one by one into the house's types, with every fault noted.
#pragma once

#include "engine/base/vector.h"
#include "engine/project/json_value.h"

#include <numbers>
#include <string>
#include <string_view>
#include <vector>

namespace hanei {

/// Degrees of a file in radians.
inline constexpr FileUnit degree{std::numbers::pi_v<long double>, 180.0};

/// What all readers of one file share.
struct JsonReading {
    std::string file;
    Diagnostics findings;

    void error(const JsonValue& at, const std::string& path, const std::string& message);
    void warn(const JsonValue& at, const std::string& path, const std::string& message);
};

/// What a message calls a value: its digits, its text, "a list of 3".
std::string described(const JsonValue& value);

// Each takes one value, or notes why not and leaves the target as it was.
bool take_value(JsonReading& reading, const JsonValue& value, const std::string& path, double& target);
bool take_value(JsonReading& reading, const JsonValue& value, const std::string& path, int& target);
bool take_value(JsonReading& reading, const JsonValue& value, const std::string& path, bool& target);
bool take_value(JsonReading& reading, const JsonValue& value, const std::string& path, std::string& target);
bool take_value(JsonReading& reading, const JsonValue& value, const std::string& path, Vec2& target);
bool take_value(JsonReading& reading, const JsonValue& value, const std::string& path, Vec3& target);
bool take_list(JsonReading& reading, const JsonValue& value, const std::string& path);

template <class T>
bool take_value(JsonReading& reading, const JsonValue& value, const std::string& path, std::vector<T>& target) {
    if (!take_list(reading, value, path)) return false;
    std::vector<T> list(value.items.size());
    bool good = true;
    for (std::size_t i = 0; i < list.size(); ++i)
        good = take_value(reading, value.items[i], path + '[' + std::to_string(i) + ']', list[i]) && good;
    if (good) target = std::move(list);
    return good;
}

/// The fields of one object. What nobody asked for is unknown.
class Fields {
public:
    /// Notes a fault when `value` is no object; then there are no fields and none is missed.
    Fields(JsonReading& reading, const JsonValue& value, std::string path);

    JsonReading& reading() { return reading_; }
    const JsonValue& value() const { return value_; }
    const std::string& path() const { return path_; }
    std::string path_of(std::string_view key) const;

    bool has(std::string_view key) const { return value_.find(key) != nullptr; }
    const JsonValue* take(std::string_view key);  ///< null when absent

    /// Leaves the target as it is when the field is absent.
    template <class T>
    bool optional(std::string_view key, T& target) {
        const JsonValue* const value = take(key);
        return value != nullptr && take_value(reading_, *value, path_of(key), target);
    }

    /// `expected` says what the field shall hold, for the message when it is absent.
    template <class T>
    bool require(std::string_view key, T& target, std::string_view expected) {
        if (!has(key)) missing(key, expected);
        return optional(key, target);
    }

    /// A number in a unit of the file's; the target is left as it is when the field is absent.
    void optional_scaled(std::string_view key, FileUnit unit, double& target);
    void optional_angle(std::string_view key, double& target) { optional_scaled(key, degree, target); }

    void missing(std::string_view key, std::string_view expected);
    void error(std::string_view key, const std::string& message);  ///< at the field, or the object when absent

    /// The fields nobody asked for, as the text of a JSON object; each is warned about. Empty when
    /// there are none.
    std::string unknown();
    /// The same, not yet as text: for objects whose unknown fields are kept with their parent.
    JsonValue unknown_object() { return unknown_object("it is kept as it is"); }
    /// For objects that nothing keeps unknown fields with: says that they will be lost.
    void drop_unknown() { unknown_object("it will be lost when the project is saved"); }

private:
    JsonValue unknown_object(const char* consequence);

    JsonReading& reading_;
    const JsonValue& value_;
    std::string path_;
    std::vector<std::string> taken_;
};

/// Calls `read(fields, index)` for each object of a list field; an absent field is an empty list.
template <class Read>
void for_each_object(Fields& parent, std::string_view key, Read read) {
    const JsonValue* const list = parent.take(key);
    if (list == nullptr || !take_list(parent.reading(), *list, parent.path_of(key))) return;
    for (std::size_t i = 0; i < list->items.size(); ++i) {
        Fields fields(parent.reading(), list->items[i], parent.path_of(key) + '[' + std::to_string(i) + ']');
        read(fields, i);
    }
}

}  // namespace hanei
