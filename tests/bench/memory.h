/// Resident memory of this process, as Linux counts it.
#pragma once

namespace hanei::bench {

/// Begins a new peak at what is resident now.
void forget_peak_memory();

/// MB, since then; of the whole process where the system keeps no newer peak.
double peak_memory_mb();

}  // namespace hanei::bench
