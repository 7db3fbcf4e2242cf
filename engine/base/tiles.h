/// Work cut into tiles whose borders never depend on the number of threads.
#pragma once

#include "engine/base/progress.h"

#include <cstddef>
#include <functional>

namespace hanei {

/// Calls `tile(begin, end)` for consecutive ranges of at most `tile_size` items covering [0, count).
///
/// Needs     a body that writes only what belongs to its own items; then the result has the same
///           bits on any number of threads. Sums are taken afterwards, in item order.
/// Returns   false when stopped before every tile ran. Progress advances from 0 to 1.
/// Cost      one atomic a tile; some microseconds to wake helpers unless one thread is enough. Those that
///           are still asleep at the end are not waited for.
bool for_each_tile(std::size_t count, std::size_t tile_size, const Work& work,
                   const std::function<void(std::size_t begin, std::size_t end)>& tile);

/// The machine's threads, at least 1.
int hardware_threads();

}  // namespace hanei
