#include "engine/study/job.h"

#include "tests/box_room.h"

#include <chrono>
#include <gtest/gtest.h>

namespace hanei {
namespace {

/// Waits for the job's wake-ups as the window does.
class JobTest : public testing::Test {
protected:
    void wake() {
        {
            const std::scoped_lock lock(guard_);
            ++wakes_;
        }
        woken_.notify_one();
    }
    SolutionSnapshot wait_for_complete() {
        while (true) {
            std::unique_lock lock(guard_);
            if (!woken_.wait_for(lock, std::chrono::seconds(60), [&] { return wakes_ > 0; })) return nullptr;
            wakes_ = 0;
            lock.unlock();
            if (auto solution = job_.take(); solution && solution->complete) return solution;
        }
    }
    static SceneSnapshot office() { return std::make_shared<const Scene>(test::small_office()); }
    static Settings settings() {
        Settings settings;
        settings.max_patch = 0.8;
        return settings;
    }

    std::mutex guard_;
    std::condition_variable woken_;
    int wakes_ = 0;
    Job job_{[this] { wake(); }};
};

TEST_F(JobTest, an_answer_carries_the_request_that_made_it) {
    const auto scene = office();
    job_.start(scene, settings(), StudyRequest{});
    const auto solution = wait_for_complete();
    ASSERT_TRUE(solution);
    EXPECT_EQ(solution->scene, scene);
    EXPECT_EQ(solution->settings, settings());
}

TEST_F(JobTest, the_newest_request_wins) {
    SceneSnapshot last;
    for (int k = 0; k < 20; ++k) {
        last = office();
        job_.start(last, settings(), StudyRequest{});
    }
    SolutionSnapshot solution;
    do {
        solution = wait_for_complete();
        ASSERT_TRUE(solution);
    } while (solution->scene != last);
    EXPECT_EQ(solution->scene, last);
}

TEST_F(JobTest, a_cancelled_study_delivers_nothing) {
    Settings slow = settings();
    slow.max_patch = 0.05;
    job_.start(office(), slow, StudyRequest{});
    job_.cancel();
    while (job_.busy()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_EQ(job_.take(), nullptr);
}

TEST_F(JobTest, a_question_about_a_place_is_answered_beside_the_studies) {
    job_.start(office(), settings(), StudyRequest{});
    const auto solution = wait_for_complete();
    ASSERT_TRUE(solution);
    job_.ask({solution, {1.0, 1.0, 0.0}, {0.0, 0.0, 1.0}});
    std::shared_ptr<const Contributions> made;
    while (!made) {
        std::unique_lock lock(guard_);
        ASSERT_TRUE(woken_.wait_for(lock, std::chrono::seconds(60), [&] { return wakes_ > 0; }));
        wakes_ = 0;
        lock.unlock();
        made = job_.take_contributions();
    }
    EXPECT_EQ(made->solution, solution);
    EXPECT_GT(made->value.total().value, 0.0);
    EXPECT_EQ(job_.take_contributions(), nullptr);
}

TEST_F(JobTest, a_study_goes_before_a_question) {
    job_.start(office(), settings(), StudyRequest{});
    const auto solution = wait_for_complete();
    ASSERT_TRUE(solution);
    for (int k = 0; k < 5; ++k) job_.ask({solution, {1.0, 1.0, 0.1 * k}, {0.0, 0.0, 1.0}});
    const auto scene = office();
    job_.start(scene, settings(), StudyRequest{});
    const auto next = wait_for_complete();
    ASSERT_TRUE(next);
    EXPECT_EQ(next->scene, scene);
}

TEST_F(JobTest, ending_the_program_does_not_wait_for_a_long_study) {
    Settings slow = settings();
    slow.max_patch = 0.04;
    job_.start(office(), slow, StudyRequest{});
}

}  // namespace
}  // namespace hanei
