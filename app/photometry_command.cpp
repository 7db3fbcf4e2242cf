#include "app/photometry_command.h"

#include "app/exit_code.h"
#include "app/files.h"
#include "engine/project/luminaire_file.h"
#include "engine/report/photometry_report.h"

#include <ostream>

namespace hanei {

int photometry_command(const std::filesystem::path& file, const std::optional<std::filesystem::path>& json,
                       std::ostream& out, std::ostream& err) {
    const LuminaireFileRead read = read_luminaire_file(file);
    for (const Diagnostic& finding : read.findings) err << to_text(finding) << '\n';
    if (!read.photometry) return exit_bad_input;
    out << photometry_text(*read.photometry);
    if (json) write_text(*json, photometry_json(*read.photometry, file.string()));
    return exit_done;
}

}  // namespace hanei
