/// Threads that stand by to help with a computation.
#pragma once

#include <condition_variable>
#include <functional>
#include <list>
#include <mutex>
#include <thread>
#include <vector>

namespace hanei {

/// Started when first needed and asleep in between: to wake one takes a few microseconds, to start one
/// ten times as long.
class Helpers {
public:
    static Helpers& of_program();

    ~Helpers();

    /// Calls `work()` here and on up to `count` other threads, and returns when all that began it have
    /// ended. A helper that does not come before the caller is through is not waited for: the work must
    /// be such that any number of callers finishes it. Any thread may ask, a helper at work as well.
    ///
    /// Needs     work that throws nothing.
    void share(int count, const std::function<void()>& work);

private:
    struct Call {
        const std::function<void()>* work;
        int wanted;      ///< helpers that may still come
        int inside = 0;  ///< that are at it
        std::condition_variable left;
    };

    Helpers() = default;
    void start_threads(int count);
    void stand_by();
    void help(Call& call, std::unique_lock<std::mutex>& lock);

    std::mutex guard_;
    std::condition_variable wake_;
    std::list<Call*> calls_;  ///< that want helpers
    bool ending_ = false;
    std::vector<std::jthread> threads_;
};

}  // namespace hanei
