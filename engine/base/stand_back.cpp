#include "engine/base/stand_back.h"

#include <sys/resource.h>
#include <unistd.h>

namespace hanei {

void stand_back() {
    constexpr int steps = 5;
    const auto thread = static_cast<id_t>(gettid());
    setpriority(PRIO_PROCESS, thread, getpriority(PRIO_PROCESS, thread) + steps);
}

}  // namespace hanei
