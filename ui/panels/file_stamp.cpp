#include "ui/panels/file_stamp.h"

namespace hanei {

FileStamp stamp_of(const std::filesystem::path& file) {
    std::error_code failure;
    FileStamp stamp;
    stamp.time = std::filesystem::last_write_time(file, failure);
    if (failure) return {};
    stamp.size = std::filesystem::file_size(file, failure);
    if (failure) return {};
    stamp.is_there = true;
    return stamp;
}

}  // namespace hanei
