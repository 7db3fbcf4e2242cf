/// A nameless file for what does not fit into memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace hanei {

/// Gone from the folder as soon as it is open, so that nothing is left behind whatever happens.
///
/// Needs     a folder that can be written. Parts never written take no room.
/// Returns   std::system_error with a sentence for the user when the disk is full or refuses.
/// Cost      any thread may read and write, different parts at once.
class SpillFile {
public:
    explicit SpillFile(std::filesystem::path folder);
    ~SpillFile();
    SpillFile(const SpillFile&) = delete;
    SpillFile& operator=(const SpillFile&) = delete;

    void write(std::size_t at, std::span<const std::byte> bytes);
    void read(std::size_t at, std::span<std::byte> bytes) const;

private:
    [[noreturn]] void fail(int error, const char* what) const;

    std::filesystem::path folder_;
    int file_ = -1;
};

}  // namespace hanei
