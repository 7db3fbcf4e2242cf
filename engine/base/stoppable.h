/// The wish that the work of a thread end, for readers that are called too deep to be handed it.
#pragma once

#include <stop_token>

namespace hanei {

/// Thrown by stop_if_wished() only, and caught where the Stoppable stands.
struct Stopped {};

/// While it lives, stop_if_wished() on this thread obeys this wish. None within another.
class Stoppable {
public:
    explicit Stoppable(std::stop_token wish);
    ~Stoppable();
    Stoppable(const Stoppable&) = delete;
    Stoppable& operator=(const Stoppable&) = delete;
};

/// Throws Stopped when the thread's work shall end; never on a thread without a Stoppable.
/// Cost      a look at one word: not for the innermost loops.
void stop_if_wished();

}  // namespace hanei
