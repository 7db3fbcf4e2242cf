// Bytes that are no zip container become the product.xml of one: the fuzzer cannot guess checksums.

#include "engine/base/check.h"
#include "engine/project/gldf_container.h"
#include "engine/project/gldf_file.h"
#include "tests/fuzz/what_holds.h"

#include <string>
#include <utility>
#include <vector>
#include <zip.h>

namespace {

constexpr std::string_view ies = "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 1\n0 90\n0\n100 0\n";

std::string container_of(std::string_view product) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* const memory = zip_source_buffer_create(nullptr, 0, 0, &error);
    zip_source_keep(memory);
    zip_t* const archive = zip_open_from_source(memory, ZIP_TRUNCATE, &error);
    const std::vector<std::pair<const char*, std::string_view>> entries{
        {"product.xml", product}, {"ldc/a.ies", ies}, {"ldc/b.ldt", "no photometry"}};
    for (const auto& [name, bytes] : entries) {
        zip_source_t* const source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
        zip_set_file_compression(archive, static_cast<zip_uint64_t>(zip_file_add(archive, name, source, 0)),
                                 ZIP_CM_STORE, 0);
    }
    HANEI_CHECK(zip_close(archive) == 0);
    zip_stat_t stat;
    zip_source_stat(memory, &stat);
    std::string bytes(stat.size, '\0');
    zip_source_open(memory);
    zip_source_read(memory, bytes.data(), bytes.size());
    zip_source_close(memory);
    zip_source_free(memory);
    zip_error_fini(&error);
    return bytes;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string_view text = hanei::text_of(bytes, count);
    const std::string container = hanei::looks_like_zip(text) ? std::string{text} : container_of(text);
    const hanei::GldfRead read = hanei::read_gldf(container, "file");
    hanei::check_findings(read.findings, !hanei::has_errors(read.findings));
    HANEI_CHECK(!read.luminaires.empty() || hanei::has_errors(read.findings));
    for (const hanei::NamedPhotometry& luminaire : read.luminaires) {
        HANEI_CHECK(!luminaire.name.empty());
        hanei::check_photometry(luminaire.photometry);
    }
    return 0;
}
