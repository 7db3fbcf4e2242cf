/// Things that are dear to make and can be used again, one user at a time.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace hanei {

/// As many are made as threads ask at once. What a thing remembers from one use to the next must not
/// show in its answers: which thread gets which is chance.
template <class T>
class Spare {
public:
    explicit Spare(std::function<T()> make) : make_(std::move(make)) {}

    /// Calls `use(thing)`.
    template <class Use>
    void with(Use&& use) {
        std::unique_ptr<T> thing = take();
        use(*thing);
        const std::scoped_lock lock(guard_);
        idle_.push_back(std::move(thing));
    }

private:
    std::unique_ptr<T> take() {
        {
            const std::scoped_lock lock(guard_);
            if (!idle_.empty()) {
                std::unique_ptr<T> thing = std::move(idle_.back());
                idle_.pop_back();
                return thing;
            }
        }
        return std::make_unique<T>(make_());
    }

    std::function<T()> make_;
    std::mutex guard_;
    std::vector<std::unique_ptr<T>> idle_;
};

}  // namespace hanei
