// The common door: what a file is, is found in its content.

#include "engine/base/check.h"
#include "engine/project/luminaires.h"
#include "tests/fuzz/what_holds.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const hanei::LuminairesRead read = hanei::read_luminaires(hanei::text_of(bytes, count), "file");
    hanei::check_findings(read.findings, !hanei::has_errors(read.findings));
    HANEI_CHECK(!read.luminaires.empty() || hanei::has_errors(read.findings));
    for (const hanei::NamedPhotometry& luminaire : read.luminaires) hanei::check_photometry(luminaire.photometry);
    return 0;
}
