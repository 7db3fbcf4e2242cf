#include "engine/base/helpers.h"

namespace hanei {

Helpers& Helpers::of_program() {
    static Helpers helpers;
    return helpers;
}

Helpers::~Helpers() {
    {
        const std::scoped_lock lock(guard_);
        ending_ = true;
    }
    wake_.notify_all();
    threads_.clear();
}

void Helpers::share(int count, const std::function<void()>& work) {
    Call call{&work, count, 0, {}};
    if (count > 0) {
        {
            const std::scoped_lock lock(guard_);
            start_threads(count);
            calls_.push_back(&call);
        }
        for (int k = 0; k < count; ++k) wake_.notify_one();
    }
    work();
    if (count <= 0) return;
    std::unique_lock lock(guard_);
    calls_.remove(&call);
    call.left.wait(lock, [&] { return call.inside == 0; });
}

void Helpers::start_threads(int count) {
    while (threads_.size() < static_cast<std::size_t>(count)) threads_.emplace_back([this] { stand_by(); });
}

void Helpers::stand_by() {
    std::unique_lock lock(guard_);
    while (true) {
        wake_.wait(lock, [&] { return ending_ || !calls_.empty(); });
        if (ending_) return;
        help(*calls_.front(), lock);
    }
}

/// The call stays where it is until nobody is inside, seen under the lock.
void Helpers::help(Call& call, std::unique_lock<std::mutex>& lock) {
    ++call.inside;
    if (--call.wanted == 0) calls_.remove(&call);
    lock.unlock();
    (*call.work)();
    lock.lock();
    if (--call.inside == 0) call.left.notify_one();
}

}  // namespace hanei
