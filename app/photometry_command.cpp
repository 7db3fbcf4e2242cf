#include "app/photometry_command.h"

#include "app/exit_code.h"
#include "app/files.h"
#include "engine/project/luminaires.h"
#include "engine/report/photometry_report.h"

#include <ostream>

namespace hanei {

int photometry_command(const std::filesystem::path& file, const std::optional<std::filesystem::path>& json,
                       std::ostream& out, std::ostream& err) {
    LuminairesRead read = read_luminaires(file);
    for (const Diagnostic& finding : read.findings) err << to_text(finding) << '\n';
    if (read.luminaires.empty()) return exit_bad_input;
    std::vector<Photometry> photometries;
    for (NamedPhotometry& luminaire : read.luminaires) {
        luminaire.photometry.name = luminaire.name;
        out << (photometries.empty() ? "" : "\n") << photometry_text(luminaire.photometry);
        photometries.push_back(std::move(luminaire.photometry));
    }
    if (json) write_text(*json, photometries_json(photometries, file.string()));
    return exit_done;
}

}  // namespace hanei
