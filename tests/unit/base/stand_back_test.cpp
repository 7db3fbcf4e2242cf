#include "engine/base/stand_back.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

namespace hanei {
namespace {

int niceness() { return getpriority(PRIO_PROCESS, static_cast<id_t>(gettid())); }

TEST(StandBack, lets_this_thread_and_those_it_starts_wait_and_no_other) {
    const int usual = niceness();
    int here = usual, started_from_here = usual;
    std::thread([&] {
        stand_back();
        here = niceness();
        std::thread([&] { started_from_here = niceness(); }).join();
    }).join();
    EXPECT_GT(here, usual);
    EXPECT_EQ(started_from_here, here);
    EXPECT_EQ(niceness(), usual);
}

}  // namespace
}  // namespace hanei
