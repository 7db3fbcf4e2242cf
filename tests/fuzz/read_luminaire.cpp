// The common door: what a file is, is found in its content.

#include "engine/base/check.h"
#include "engine/project/luminaire_file.h"
#include "tests/fuzz/what_holds.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const hanei::LuminaireFileRead read = hanei::read_luminaire_text(hanei::text_of(bytes, count), "file");
    hanei::check_findings(read.findings, read.photometry.has_value());
    if (read.photometry) hanei::check_photometry(*read.photometry);
    return 0;
}
