#include "engine/base/whole_file.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace hanei {
namespace {

namespace fs = std::filesystem;

std::string sentence_of(int reason) {
    switch (reason) {
        case ENOSPC:
        case EDQUOT:
            return "the disk is full; make room, or save to another place";
        case EFBIG:
            return "files may not become so large here; save to another place";
        case EACCES:
        case EPERM:
            return "you may not write in this folder; save to another place";
        case EROFS:
            return "this disk can only be read; save to another place";
        case ENOENT:
        case ENOTDIR:
            return "there is no such folder; choose one that is there";
        case ENAMETOOLONG:
            return "the name is too long; take a shorter one";
        default:
            return "the file cannot be written (" + std::generic_category().message(reason) +
                   "); save to another place";
    }
}

/// Where a symbolic link leads in the end, there or not.
fs::path end_of_links(fs::path file) {
    constexpr int most_links = 40;  // as the system follows
    std::error_code none;
    for (int k = 0; k < most_links && fs::is_symlink(fs::symlink_status(file, none)); ++k) {
        const fs::path next = fs::read_symlink(file, none);
        if (none) break;
        file = next.is_absolute() ? next : file.parent_path() / next;
    }
    return file;
}

class OpenFile {
public:
    OpenFile(const fs::path& file, int how, mode_t mode = 0) : number_(::open(file.c_str(), how | O_CLOEXEC, mode)) {}
    ~OpenFile() {
        if (number_ >= 0) ::close(number_);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    int number() const { return number_; }
    bool close() { return ::close(std::exchange(number_, -1)) == 0; }

private:
    int number_;
};

bool write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

/// 0, or why the file could not be made.
int write_new(const fs::path& file, std::string_view bytes, const struct stat* like, bool lasts) {
    constexpr mode_t usual = 0666;  // less what the user's umask takes away
    OpenFile out(file, O_WRONLY | O_CREAT | O_TRUNC, usual);
    if (out.number() < 0) return errno;
    if (like != nullptr) {
        // A group we are not in cannot be kept; the rights can.
        [[maybe_unused]] const int kept = ::fchown(out.number(), like->st_uid, like->st_gid);
        if (::fchmod(out.number(), like->st_mode & 07777) != 0) return errno;
    }
    if (!write_all(out.number(), bytes) || (lasts && ::fsync(out.number()) != 0) || !out.close()) return errno;
    return 0;
}

std::optional<std::string> replace(const fs::path& named, std::string_view bytes, bool lasts) {
    const fs::path file = end_of_links(named);
    struct stat before {};
    const bool exists = ::stat(file.c_str(), &before) == 0;
    if (exists && !S_ISREG(before.st_mode)) return "this is no plain file; name another one";
    fs::path beside = file;
    beside += ".part" + std::to_string(::getpid());
    std::error_code ignored;
    if (const int reason = write_new(beside, bytes, exists ? &before : nullptr, lasts)) {
        fs::remove(beside, ignored);
        return sentence_of(reason);
    }
    if (::rename(beside.c_str(), file.c_str()) != 0) {
        const int reason = errno;
        fs::remove(beside, ignored);
        return sentence_of(reason);
    }
    if (!lasts) return std::nullopt;
    // The new name itself is kept only when the folder is; some file systems cannot say.
    const fs::path folder = file.parent_path();
    const OpenFile names(folder.empty() ? fs::path(".") : folder, O_RDONLY | O_DIRECTORY);
    if (names.number() >= 0) ::fsync(names.number());
    return std::nullopt;
}

}  // namespace

std::optional<std::string> write_whole_file(const fs::path& file, std::string_view bytes) {
    return replace(file, bytes, true);
}

std::optional<std::string> write_passing_file(const fs::path& file, std::string_view bytes) {
    return replace(file, bytes, false);
}

std::optional<std::string> make_folder(const fs::path& folder) {
    std::error_code reason;
    fs::create_directories(folder, reason);
    if (!reason || fs::is_directory(folder)) return std::nullopt;
    if (reason == std::errc::not_a_directory || reason == std::errc::file_exists)
        return "there is a file where a folder is needed; choose another place";
    return sentence_of(reason.value());
}

}  // namespace hanei
