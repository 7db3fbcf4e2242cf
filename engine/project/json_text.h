/// JSON trees as text that people read: short things on one line, long ones opened.
#pragma once

#include "engine/project/json_value.h"

namespace hanei {

/// One line, no break: "{"a": 1, "b": [2, 3]}".
std::string one_line(const JsonValue& value);

/// Lines of at most 120 characters where values allow it; what fits on one line stays on it, lists
/// of numbers are filled like prose. Ends with a line end.
std::string json_document(const JsonValue& value);

}  // namespace hanei
