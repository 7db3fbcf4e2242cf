#include "engine/transport/spill_file.h"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <system_error>
#include <unistd.h>

namespace hanei {

SpillFile::SpillFile(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::string name = (folder_ / "hanei-rows-XXXXXX").string();
    file_ = ::mkostemp(name.data(), O_CLOEXEC);
    if (file_ < 0) fail(errno, "cannot be put");
    ::unlink(name.c_str());
}

SpillFile::~SpillFile() {
    if (file_ >= 0) ::close(file_);
}

void SpillFile::write(std::size_t at, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t done = ::pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(at));
        if (done < 0 && errno == EINTR) continue;
        if (done <= 0) fail(done < 0 ? errno : ENOSPC, "cannot be written");
        at += static_cast<std::size_t>(done);
        bytes = bytes.subspan(static_cast<std::size_t>(done));
    }
}

void SpillFile::read(std::size_t at, std::span<std::byte> bytes) const {
    while (!bytes.empty()) {
        const ssize_t done = ::pread(file_, bytes.data(), bytes.size(), static_cast<off_t>(at));
        if (done < 0 && errno == EINTR) continue;
        if (done <= 0) fail(done < 0 ? errno : EIO, "cannot be read back");
        at += static_cast<std::size_t>(done);
        bytes = bytes.subspan(static_cast<std::size_t>(done));
    }
}

void SpillFile::fail(int error, const char* what) const {
    std::string message = "The coefficients of interreflection do not fit into memory and ";
    message += what;
    message += " in the folder " + folder_.string() + "; use fewer patches, or a folder with more room";
    throw std::system_error(error, std::generic_category(), message);
}

}  // namespace hanei
