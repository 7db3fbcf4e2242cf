/// Disks that refuse: a really full one where a process may mount one, files that may not grow, folders that
/// may not be written.
#pragma once

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sched.h>
#include <string>
#include <sys/fsuid.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace hanei {

/// A disk of some pages in memory, seen by this thread, what it starts, and nobody else.
class SmallDisk {
public:
    static constexpr std::size_t page = 4096;

    SmallDisk(std::filesystem::path folder, std::size_t pages) : folder_(std::move(folder)) {
        std::filesystem::create_directories(folder_);
        const std::string size = "size=" + std::to_string(pages * page);
        is_there_ = has_own_mounts() && ::mount("none", folder_.c_str(), "tmpfs", 0, size.c_str()) == 0;
    }
    ~SmallDisk() {
        if (is_there_) ::umount2(folder_.c_str(), MNT_DETACH);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    bool is_there() const { return is_there_; }

    /// Fills it until so many pages are free.
    void leave(std::size_t pages) {
        const std::filesystem::path ballast = folder_ / "ballast";
        std::filesystem::remove(ballast);
        const auto free = static_cast<std::size_t>(std::filesystem::space(folder_).available) / page;
        if (free <= pages) return;
        std::ofstream(ballast, std::ios::binary) << std::string((free - pages) * page, 'x');
    }

private:
    static bool has_own_mounts() {
        static const bool has = [] {
            const auto user = ::getuid(), group = ::getgid();
            if (::unshare(CLONE_NEWNS) != 0) {
                if (::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
                std::ofstream("/proc/self/setgroups") << "deny";
                std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
                std::ofstream("/proc/self/gid_map") << "0 " << group << " 1";
            }
            return ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
        }();
        return has;
    }
    std::filesystem::path folder_;
    bool is_there_ = false;
};

/// While it lives no file of this process may become larger than this.
class FilesAtMost {
public:
    explicit FilesAtMost(std::size_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit tight{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &tight);
    }
    ~FilesAtMost() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FilesAtMost(const FilesAtMost&) = delete;
    FilesAtMost& operator=(const FilesAtMost&) = delete;

private:
    rlimit before_{};
    void (*handler_)(int);
};

/// A folder that may only be read, by the superuser neither, who is nobody for files meanwhile.
class ReadOnlyFolder {
public:
    explicit ReadOnlyFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
        ::chmod(folder_.c_str(), 0555);
        if (::geteuid() == 0) ::setfsuid(65534);
    }
    ~ReadOnlyFolder() {
        if (::geteuid() == 0) ::setfsuid(0);
        ::chmod(folder_.c_str(), 0755);
    }
    ReadOnlyFolder(const ReadOnlyFolder&) = delete;
    ReadOnlyFolder& operator=(const ReadOnlyFolder&) = delete;

private:
    std::filesystem::path folder_;
};

}  // namespace hanei
