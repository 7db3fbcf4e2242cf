#include "engine/project/ies_file.h"
#include "tests/fuzz/what_holds.h"

#include <string>

namespace {

std::vector<hanei::Photometry> read(std::string_view text, hanei::LuminaireFindings& findings) {
    // a TILT file of any name lies beside it: what follows the name in the file itself
    const auto beside = [text](const std::string& name) {
        const std::size_t place = text.find(name);
        return std::string{place == std::string_view::npos ? text : text.substr(place + name.size())};
    };
    return {hanei::read_ies(text, beside, findings)};
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    hanei::check_reader(read, bytes, count);
    return 0;
}
