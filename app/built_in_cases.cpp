#include "app/built_in_cases.h"

#include "app/files.h"
#include "engine/base/tiles.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>

namespace hanei {
namespace {

/// Today; that of SOURCE_DATE_EPOCH where output shall be the same on any day.
std::string date_of_signing() {
    std::time_t now = std::time(nullptr);
    if (const char* const fixed = std::getenv("SOURCE_DATE_EPOCH")) now = std::strtoll(fixed, nullptr, 10);
    std::tm parts{};
    char text[16] = "";
    if (::gmtime_r(&now, &parts) != nullptr) std::strftime(text, sizeof text, "%Y-%m-%d", &parts);
    return text;
}

void add_method(std::string& methods, const std::string& method) {
    if (method.empty() || methods.find(method) != std::string::npos) return;
    if (!methods.empty()) methods += " and ";
    methods += method;
}

}  // namespace

BuiltInCases built_in_cases() {
    BuiltInCases cases;
    ReferenceIndex index = read_reference_index(own_file("assets/reference/index.json"));
    cases.findings = std::move(index.findings);
    for (const ReferenceEntry& entry : index.entries) {
        ReferenceRead read = read_reference(entry.file);
        cases.findings.insert(cases.findings.end(), read.findings.begin(), read.findings.end());
        for (ReferenceCase& reference : read.cases) cases.cases.push_back({entry, std::move(reference)});
    }
    return cases;
}

std::optional<Validation> validate(const BuiltInCases& cases, const SettingsChange& change, const Work& work,
                                   const std::function<void(const CaseVerdict&, const ValidationRow&)>& told) {
    Settings settings;
    if (change) change(settings);
    Validation validation;
    validation.version = HANEI_VERSION;
    validation.date = date_of_signing();
    validation.threads = settings.threads > 0 ? settings.threads : hardware_threads();
    const auto begin = std::chrono::steady_clock::now();
    for (const BuiltInCases::Case& built_in : cases.cases) {
        if (work.stop.stop_requested()) return std::nullopt;
        const auto verdict = run_reference(built_in.reference, change, {work.threads, work.stop, nullptr});
        if (!verdict) return std::nullopt;
        validation.rows.push_back(row_of(*verdict, built_in.entry.proves, built_in.entry.source));
        add_method(validation.methods, verdict->method);
        if (told) told(*verdict, validation.rows.back());
        if (work.progress)
            work.progress->advance(static_cast<float>(validation.rows.size()) / static_cast<float>(cases.cases.size()));
    }
    validation.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return validation;
}

}  // namespace hanei
