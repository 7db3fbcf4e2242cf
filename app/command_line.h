#pragma once

namespace hanei {

/// Reads the arguments and runs the command they name. Returns the program's exit code.
int run_command_line(int argc, char** argv);

}  // namespace hanei
