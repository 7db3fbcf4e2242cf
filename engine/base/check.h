/// Our own mistakes stop the program, in release too: a wrong lux figure costs more than a crash.
#pragma once

namespace hanei {

[[noreturn]] void check_failed(const char* condition, const char* file, int line);

}  // namespace hanei

#define HANEI_CHECK(condition) ((condition) ? void(0) : ::hanei::check_failed(#condition, __FILE__, __LINE__))
