#include "engine/base/tiles.h"

#include "engine/base/check.h"
#include "engine/base/helpers.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>

namespace hanei {

bool for_each_tile(std::size_t count, std::size_t tile_size, const Work& work,
                   const std::function<void(std::size_t begin, std::size_t end)>& tile) {
    HANEI_CHECK(tile_size > 0);
    const std::size_t tiles = (count + tile_size - 1) / tile_size;
    std::atomic<std::size_t> next = 0;
    std::atomic<std::size_t> finished = 0;
    std::exception_ptr failure;
    std::mutex failure_guard;

    const auto worker = [&] {
        while (!work.stop.stop_requested()) {
            const std::size_t k = next++;
            if (k >= tiles) return;
            try {
                tile(k * tile_size, std::min(count, (k + 1) * tile_size));
            } catch (...) {
                const std::scoped_lock lock(failure_guard);
                failure = std::current_exception();
                next = tiles;
                return;
            }
            const std::size_t done = ++finished;
            if (work.progress) work.progress->advance(static_cast<float>(done) / static_cast<float>(tiles));
        }
    };

    const std::size_t workers = std::min<std::size_t>(static_cast<std::size_t>(std::max(1, work.threads)), tiles);
    if (workers > 1) {
        Helpers::of_program().share(static_cast<int>(workers) - 1, worker);
    } else {
        worker();
    }
    if (failure) std::rethrow_exception(failure);
    return finished == tiles;
}

int hardware_threads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

}  // namespace hanei
