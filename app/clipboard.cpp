#include "app/clipboard.h"

#include "engine/base/whole_file.h"

#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

extern char** environ;

namespace hanei {
namespace {

/// Runs a tool with a file as its input and nothing to say. Its exit code; -1 when it is not installed.
int run(std::vector<std::string> words, const std::filesystem::path& input) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t files{};
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, 0, input.c_str(), O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&files, 2, "/dev/null", O_WRONLY, 0);
    pid_t process = 0;
    const int failure = ::posix_spawnp(&process, arguments[0], &files, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    if (failure != 0) return -1;
    int status = 0;
    if (::waitpid(process, &status, 0) < 0 || !WIFEXITED(status)) return 126;
    return WEXITSTATUS(status) == 127 ? -1 : WEXITSTATUS(status);
}

bool is_set(const char* variable) {
    const char* const value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}

}  // namespace

std::optional<std::string> copy_png(std::string_view png) {
    const bool wayland = is_set("WAYLAND_DISPLAY");
    if (!wayland && !is_set("DISPLAY")) return "there is no display whose clipboard could take the picture";
    std::error_code failure;
    const std::filesystem::path file =
        std::filesystem::temp_directory_path(failure) / fmt::format("hanei-clipboard-{}.png", ::getpid());
    if (const auto reason = write_whole_file(file, png)) return file.string() + ": " + *reason;
    const std::vector<std::string> words =
        wayland ? std::vector<std::string>{"wl-copy", "--type", "image/png"}
                : std::vector<std::string>{"xclip", "-selection", "clipboard", "-t", "image/png", "-i"};
    const int code = run(words, file);
    std::filesystem::remove(file, failure);
    if (code == 0) return std::nullopt;
    if (code == -1)
        return fmt::format(
            "pictures go to the clipboard by {0}, which is not installed: install the package {1}, or "
            "export the picture",
            words[0], wayland ? "wl-clipboard" : "xclip");
    return fmt::format("{} refused the picture (exit code {}); export it instead", words[0], code);
}

}  // namespace hanei
