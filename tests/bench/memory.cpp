#include "tests/bench/memory.h"

#include <fstream>
#include <string>
#include <sys/resource.h>

namespace hanei::bench {

void forget_peak_memory() { std::ofstream("/proc/self/clear_refs") << 5; }

double peak_memory_mb() {
    constexpr double kib_a_mb = 1024.0;
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        double kib = 0.0;
        if (word == "VmHWM:" && status >> kib) return kib / kib_a_mb;
    }
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / kib_a_mb;
}

}  // namespace hanei::bench
