#include "app/photometry_command.h"

#include "app/exit_code.h"
#include "app/files.h"
#include "engine/project/luminaires.h"
#include "engine/report/photometry_figures.h"
#include "engine/report/photometry_report.h"
#include "engine/scene/intensity.h"

#include <algorithm>
#include <ostream>
#include <utility>

namespace hanei {

namespace {

/// False, with a sentence on `err`, for a set that the luminaire does not have.
bool choose_lamp_set(int wanted, const std::filesystem::path& file, Photometry& photometry, std::ostream& err) {
    const std::size_t count = photometry.lamp_sets.size();
    if (wanted < 1 || static_cast<std::size_t>(wanted) > count) {
        err << file.string() << ": lamp set " << wanted << " is asked for; " << photometry.name << " has " << count
            << '\n';
        return false;
    }
    photometry = with_lamp_set(std::move(photometry), static_cast<std::size_t>(wanted) - 1);
    return true;
}

}  // namespace

int photometry_command(const std::filesystem::path& file, std::optional<int> lamp_set,
                       const std::optional<std::filesystem::path>& json, std::ostream& out, std::ostream& err) {
    LuminairesRead read = read_luminaires(file);
    for (const Diagnostic& finding : read.findings) err << to_text(finding) << '\n';
    if (read.luminaires.empty()) return exit_bad_input;
    std::vector<Photometry> photometries;
    for (NamedPhotometry& luminaire : read.luminaires) {
        luminaire.photometry.name = luminaire.name;
        if (lamp_set && !choose_lamp_set(*lamp_set, file, luminaire.photometry, err)) return exit_bad_input;
        out << (photometries.empty() ? "" : "\n") << photometry_text(luminaire.photometry);
        photometries.push_back(std::move(luminaire.photometry));
    }
    if (json) write_text(*json, photometries_json(photometries, file.string()));
    return exit_done;
}

Diagnostics photometry_findings(const Scene& scene, const std::string& file, const Diagnostics& known) {
    Diagnostics findings;
    const auto is_known = [&known](const std::string& warning) {
        return std::any_of(known.begin(), known.end(),
                           [&warning](const Diagnostic& finding) { return warning.ends_with(finding.message); });
    };
    for (std::size_t k = 0; k < scene.photometries.size(); ++k) {
        const Photometry& photometry = scene.photometries[k];
        const auto add = [&](const std::string& sentence) {
            Diagnostic& finding = findings.emplace_back();
            finding.severity = Severity::warning;
            finding.place.file = file;
            finding.place.field = "photometries[" + std::to_string(k) + "]";
            finding.place.object = photometry.id.value;
            finding.message = photometry.name + ": " + sentence;
        };
        for (const std::string& warning : photometry.warnings) {
            if (!is_known(warning)) add(warning);
        }
        if (photometry.vertical_deg.size() < 2) continue;  // a single ring of light has no flux to compare
        for (const std::string& difference : photometry_figures(photometry).differences) add(difference);
    }
    return findings;
}

}  // namespace hanei
