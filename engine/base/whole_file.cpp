#include "engine/base/whole_file.h"

#include <fstream>
#include <system_error>
#include <unistd.h>

namespace hanei {

std::optional<std::string> write_whole_file(const std::filesystem::path& file, std::string_view bytes) {
    std::error_code error;
    if (std::filesystem::exists(file, error) && !std::filesystem::is_regular_file(file, error))
        return "this is no plain file; name another one";
    std::filesystem::path beside = file;
    beside += ".part" + std::to_string(::getpid());
    std::ofstream out(beside, std::ios::binary | std::ios::trunc);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out) {
        std::filesystem::remove(beside, error);
        return "the file cannot be written; is the folder there, is it writable, is the disk full?";
    }
    std::filesystem::rename(beside, file, error);
    if (!error) return std::nullopt;
    const std::string reason = error.message();
    std::filesystem::remove(beside, error);
    return "the file cannot be replaced: " + reason;
}

}  // namespace hanei
