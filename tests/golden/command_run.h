/// Commands as the shell would run them, and what they print.
#pragma once

#include "app/command_line.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace hanei {

class CommandRun : public testing::Test {
protected:
    /// Returns   the exit code.
    int run(const std::vector<std::string>& after_program) {
        std::vector<std::string> arguments{"hanei"};
        arguments.insert(arguments.end(), after_program.begin(), after_program.end());
        std::vector<char*> pointers;
        for (std::string& argument : arguments) pointers.push_back(argument.data());
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        const int code = run_command_line(static_cast<int>(pointers.size()), pointers.data());
        out_ = testing::internal::GetCapturedStdout();
        err_ = testing::internal::GetCapturedStderr();
        return code;
    }

    std::string out_, err_;
};

}  // namespace hanei
