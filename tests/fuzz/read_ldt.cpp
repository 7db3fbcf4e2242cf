#include "engine/project/ldt_file.h"
#include "tests/fuzz/what_holds.h"

namespace {

std::vector<hanei::Photometry> read(std::string_view text, hanei::LuminaireFindings& findings) {
    return {hanei::read_ldt(text, findings)};
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    hanei::check_reader(read, bytes, count);
    return 0;
}
