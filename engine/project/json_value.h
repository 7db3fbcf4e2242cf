/// A JSON text as a tree that remembers its lines, so that every fault can be told with its place.
#pragma once

#include "engine/base/diagnostic.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hanei {

/// Holds     its children by value. A number keeps its digits as written beside its double, so that
///           figures in other units (degrees, percent) can be converted without losing bits.
struct JsonValue {
    enum class Kind { null, boolean, number, text, list, object };

    Kind kind = Kind::null;
    bool truth = false;
    int line = 0;  ///< 1 is the first; 0 for values that no file holds
    double number = 0.0;
    std::string text;               ///< a text's characters, a number's digits
    std::vector<std::string> keys;  ///< of an object: one an item
    std::vector<JsonValue> items;   ///< of a list or an object, in file order

    bool is(Kind wanted) const { return kind == wanted; }
    const JsonValue* find(std::string_view key) const;  ///< null when absent or no object
    JsonValue& add(std::string key, JsonValue value);   ///< returns the added item
};

JsonValue json_object();
JsonValue json_list();
JsonValue json_boolean(bool truth);
JsonValue json_text(std::string text);
/// Null with the text "not finite" for what JSON cannot write.
JsonValue json_number(double value);
/// From the unit of a file to the engine's: times `multiply`, divided by `divide`.
struct FileUnit {
    long double multiply = 1.0L;
    double divide = 1.0;
};

/// A number of a file in engine units. Up to 15 digits are what people type: they are converted in
/// double, as the window does. More digits are converted more finely and rounded once, because not
/// every angle in radians has a double of degrees that leads to it.
double scaled(const JsonValue& number, FileUnit unit);

/// `value` in the unit of the file with the fewest decimals that scaled() turns back into the same bits.
JsonValue json_scaled(double value, FileUnit unit);

/// Reads a whole JSON text. `file` is what messages call it.
///
/// Returns   nothing when the text is no JSON, nests deeper than 64 levels or holds more than five
///           million values; a repeated key is an error too, but reading goes on.
/// Cost      about 150 bytes a value.
std::optional<JsonValue> parse_json(std::string_view text, const std::string& file, Diagnostics& findings);

/// The line of the deepest value that `path` ("luminaires[2].opening.outline") reaches.
int line_of(const JsonValue& root, std::string_view path);

/// A JSON text constant with its quotes; bytes that are no UTF-8 become U+FFFD.
std::string json_quoted(std::string_view text);

}  // namespace hanei
