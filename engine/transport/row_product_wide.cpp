// Compiled for machines with 256 bit vectors (CMakeLists.txt), and run on those alone.
#if defined(__AVX2__)

#include "engine/transport/row_kernel.h"

namespace hanei::row_kernel {

void run_wide(const Job& job, std::size_t sides) { run_any(job, sides); }

}  // namespace hanei::row_kernel

#endif
