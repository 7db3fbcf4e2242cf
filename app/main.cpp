#include "app/command_line.h"
#include "app/exit_code.h"

#include <cerrno>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <system_error>

namespace {

/// A full disk behind "hanei solve ... > FILE" may say so only when the last bytes go out.
int unless_output_was_lost(int code) {
    errno = 0;
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
    const std::string reason = errno == 0 ? std::string() : " (" + std::generic_category().message(errno) + ")";
    std::fprintf(stderr, "hanei: standard output does not take what is written%s\n", reason.c_str());
    return hanei::exit_machine;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return unless_output_was_lost(hanei::run_command_line(argc, argv));
    } catch (const std::bad_alloc&) {
        std::fputs("hanei: not enough memory for this\n", stderr);
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "hanei: %s\n", failure.what());
    }
    return hanei::exit_machine;
}
