#include "app/files.h"

#include "engine/base/whole_file.h"

#include <cstdio>
#include <stdexcept>

namespace hanei {

void print_findings(const Diagnostics& findings) {
    for (const Diagnostic& finding : findings) std::fprintf(stderr, "%s\n", to_text(finding).c_str());
}

std::optional<Project> open_project(const std::filesystem::path& file) {
    ProjectRead read = read_project(file);
    print_findings(read.findings);
    return std::move(read.project);
}

void write_text(const std::filesystem::path& file, std::string_view text) {
    if (const auto reason = write_whole_file(file, text)) throw std::runtime_error(file.string() + ": " + *reason);
}

std::filesystem::path own_file(const std::filesystem::path& name) {
    std::error_code failure;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", failure);
    for (auto folder = program.parent_path(); !failure && folder.has_relative_path(); folder = folder.parent_path()) {
        if (std::filesystem::exists(folder / name)) return folder / name;
        if (std::filesystem::exists(folder / "share/hanei" / name)) return folder / "share/hanei" / name;
    }
    return name;
}

std::filesystem::path start_room() { return own_file("assets/rooms/computer-room-panels.hanei"); }

}  // namespace hanei
