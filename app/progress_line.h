/// How far a command is, on one line of the terminal.
#pragma once

#include "engine/base/progress.h"

#include <thread>

namespace hanei {

/// Rewrites the line four times a second while it lives and wipes it at the end. Writes nothing
/// when stderr is no terminal.
class ProgressLine {
public:
    explicit ProgressLine(const Progress& progress);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

private:
    std::jthread writing_;
};

}  // namespace hanei
