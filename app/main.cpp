#include "app/command_line.h"
#include "app/exit_code.h"

#include <cstdio>
#include <exception>
#include <new>

int main(int argc, char** argv) {
    try {
        return hanei::run_command_line(argc, argv);
    } catch (const std::bad_alloc&) {
        std::fputs("hanei: not enough memory for this\n", stderr);
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "hanei: %s\n", failure.what());
    }
    return hanei::exit_machine;
}
