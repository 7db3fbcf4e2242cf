#pragma once

namespace hanei {

/// What other people's scripts read (README, "Exit codes").
enum ExitCode : int {
    exit_done = 0,
    exit_answer_is_no = 1,  ///< a case fails, a check fails
    exit_bad_input = 2,     ///< usage, or file:line: field: message on stderr
    exit_machine = 3,       ///< disk, memory
};

}  // namespace hanei
