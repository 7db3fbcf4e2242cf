#pragma once

#include <cstdint>
#include <filesystem>

namespace hanei {

/// What tells that a file was written since: its time and its size.
struct FileStamp {
    bool is_there = false;
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    bool operator==(const FileStamp&) const = default;
};

FileStamp stamp_of(const std::filesystem::path& file);

}  // namespace hanei
