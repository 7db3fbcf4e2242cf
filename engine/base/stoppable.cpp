#include "engine/base/stoppable.h"

#include "engine/base/check.h"

#include <utility>

namespace hanei {
namespace {

thread_local std::stop_token present_wish;

}  // namespace

Stoppable::Stoppable(std::stop_token wish) {
    HANEI_CHECK(!present_wish.stop_possible());
    present_wish = std::move(wish);
}

Stoppable::~Stoppable() { present_wish = {}; }

void stop_if_wished() {
    if (present_wish.stop_requested()) throw Stopped{};
}

}  // namespace hanei
