/// What is wrong with something the user gave: a file, a figure, a scene. All findings are
/// collected; nobody stops at the first.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace hanei {

enum class Severity { note, warning, error };

/// Where the fault is. Empty parts are unknown; line 0 is unknown.
struct Place {
    std::string file;
    int line = 0;
    std::string field;         ///< e.g. "luminaires[2].flux_lm", "vertical angles"
    std::uint32_t object = 0;  ///< ObjectId of the authored object, 0 if none: lets the window select it
    bool operator==(const Place&) const = default;
};

struct Diagnostic {
    Severity severity = Severity::error;
    Place place;
    std::string message;  ///< one sentence: what was found, what is allowed, what to do
    bool operator==(const Diagnostic&) const = default;
};

using Diagnostics = std::vector<Diagnostic>;

bool has_errors(const Diagnostics& findings);

/// "file:line: field: message", parts left out when unknown; "warning: " before the message of one.
std::string to_text(const Diagnostic& finding);

}  // namespace hanei
