#include "engine/base/diagnostic.h"

#include <algorithm>

namespace hanei {

bool has_errors(const Diagnostics& findings) {
    return std::any_of(findings.begin(), findings.end(),
                       [](const Diagnostic& finding) { return finding.severity == Severity::error; });
}

std::string to_text(const Diagnostic& finding) {
    std::string text;
    if (!finding.place.file.empty()) {
        text += finding.place.file + ':';
        if (finding.place.line > 0) text += std::to_string(finding.place.line) + ':';
        text += ' ';
    }
    if (!finding.place.field.empty()) text += finding.place.field + ": ";
    if (finding.severity == Severity::warning) text += "warning: ";
    if (finding.severity == Severity::note) text += "note: ";
    return text + finding.message;
}

}  // namespace hanei
