/// Which of a program's threads may wait.
#pragma once

namespace hanei {

/// From here on the calling thread, and those it starts, leave the processors to the program's others
/// when there is not enough for all: about a quarter of a busy processor remains theirs (five steps of
/// nice(2), which Linux counts for each thread).
///
/// Holds     nothing else changes, results least of all. Cannot be taken back.
void stand_back();

}  // namespace hanei
