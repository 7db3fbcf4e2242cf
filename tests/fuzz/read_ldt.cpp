#include "engine/project/ldt_file.h"
#include "tests/fuzz/what_holds.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    hanei::check_reader(hanei::read_ldt, bytes, count);
    return 0;
}
