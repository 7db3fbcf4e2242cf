/// Exact pictures by the command line's door.
#include "app/command_line.h"
#include "app/exit_code.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace hanei {
namespace {

const std::string room = HANEI_SOURCE "/assets/rooms/computer-room-panels.hanei";

class ExactRender : public testing::Test {
protected:
    void SetUp() override {
        ::setenv("SOURCE_DATE_EPOCH", "1700000000", 1);  // the same pictures at any time
        folder_ = std::filesystem::path(testing::TempDir()) /
                  ("hanei-exact-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }

    std::vector<std::string> render(const std::string& file, std::vector<std::string> more) const {
        std::vector<std::string> arguments{"hanei", "render", room, "--max-patch", "2", "--out", folder_ / file};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }

    int run(std::vector<std::string> arguments) {
        std::vector<char*> pointers;
        for (std::string& argument : arguments) pointers.push_back(argument.data());
        testing::internal::CaptureStderr();
        const int code = run_command_line(static_cast<int>(pointers.size()), pointers.data());
        err_ = testing::internal::GetCapturedStderr();
        return code;
    }

    std::string content(const std::string& file) const {
        std::ifstream in(folder_ / file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    std::filesystem::path folder_;
    std::string err_;
};

TEST_F(ExactRender, is_the_same_picture_on_one_thread_and_on_three_and_another_than_the_interpolated_one) {
    const std::vector<std::string> small{"--scale", "photo", "--size", "320x200", "--view", "3"};
    std::vector<std::string> exact = small;
    exact.insert(exact.end(), {"--exact", "--threads", "1"});
    ASSERT_EQ(run(render("plain.png", small)), exit_done) << err_;
    ASSERT_EQ(run(render("one.png", exact)), exit_done) << err_;
    EXPECT_NE(err_.find("direct light exact at"), std::string::npos) << err_;
    exact.back() = "3";
    ASSERT_EQ(run(render("three.png", exact)), exit_done) << err_;
    EXPECT_GT(content("one.png").size(), 10'000u);
    EXPECT_EQ(content("one.png"), content("three.png"));
    EXPECT_NE(content("one.png"), content("plain.png"));
}

TEST_F(ExactRender, draws_the_part_and_the_scale_asked_for) {
    const std::vector<std::string> small{"--exact", "--samples", "4", "--size", "160x100"};
    const auto draw = [&](const std::string& part, const std::string& scale) {
        std::vector<std::string> more = small;
        more.insert(more.end(), {"--part", part, "--scale", scale});
        EXPECT_EQ(run(render(part + scale, more)), exit_done) << err_;
        return content(part + scale);
    };
    const std::string total = draw("total", "photo");
    EXPECT_GT(total.size(), 5'000u);
    EXPECT_NE(total, draw("direct", "photo"));
    EXPECT_NE(total, draw("unshadowed", "photo"));
    EXPECT_NE(total, draw("total", "false-colour"));
}

TEST_F(ExactRender, refuses_four_parts_at_once_and_a_number_of_rays_out_of_range) {
    EXPECT_EQ(run(render("x.png", {"--exact", "--part", "four-up"})), exit_bad_input);
    EXPECT_NE(err_.find("four-up"), std::string::npos) << err_;
    EXPECT_EQ(run(render("x.png", {"--exact", "--samples", "0"})), exit_bad_input);
    EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(ExactRender, leaves_no_file_when_interrupted_and_ends_by_the_signal) {
    std::vector<std::string> arguments = render("never.png", {"--exact", "--size", "8000x5000"});
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        std::signal(SIGINT, SIG_DFL);  // a test run in the background ignores it
        execv(HANEI_PROGRAM, pointers.data());
        _exit(127);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    ASSERT_EQ(kill(child, SIGINT), 0);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) << status;
    EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

}  // namespace
}  // namespace hanei
