#include "engine/project/project_file.h"
#include "tests/fuzz/what_holds.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    // No file lies beside it: luminaire files have fuzzers of their own.
    const hanei::ProjectRead read = hanei::read_project_text(hanei::text_of(bytes, count), "/nowhere/file.hanei");
    hanei::check_findings(read.findings, read.project.has_value());
    if (read.project) hanei::check_project(*read.project);
    return 0;
}
