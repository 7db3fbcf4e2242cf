#include "engine/project/luminaire_findings.h"

#include <fmt/format.h>
#include <utility>

namespace hanei {

void LuminaireFindings::fault(int line, std::string field, std::string message) {
    if (failed_) return;
    failed_ = true;
    diagnostics_.push_back({Severity::error, {file_, line, std::move(field), 0}, std::move(message)});
}

void LuminaireFindings::warn(int line, std::string field, std::string message) {
    if (failed_) return;
    diagnostics_.push_back({Severity::warning, {file_, line, std::move(field), 0}, std::move(message)});
}

std::vector<std::string> LuminaireFindings::warning_texts() const {
    std::vector<std::string> texts;
    for (const Diagnostic& finding : diagnostics_) {
        if (finding.severity != Severity::warning) continue;
        const std::string where = finding.place.line > 0 ? fmt::format("line {}, ", finding.place.line) : "";
        texts.push_back(where + finding.place.field + ": " + finding.message);
    }
    return texts;
}

}  // namespace hanei
