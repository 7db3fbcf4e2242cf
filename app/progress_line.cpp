#include "app/progress_line.h"

#include "ui/panels/live_study.h"
#include "ui/panels/time_left.h"

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <fmt/format.h>
#include <mutex>
#include <unistd.h>

namespace hanei {
namespace {

void write_lines(const Progress& progress, const std::stop_token& end) {
    std::mutex guard;
    std::condition_variable_any woken;
    std::unique_lock lock(guard);
    TimeLeft left;
    while (!woken.wait_for(lock, end, std::chrono::milliseconds(250), [&] { return end.stop_requested(); })) {
        const Stage stage = progress.stage();
        const float fraction = progress.fraction();
        std::string line(name_of(stage));
        if (fraction > 0.0F) line += fmt::format(" {:.0f} %", 100.0F * fraction);
        const std::string rest = left.text(stage, fraction);
        if (!rest.empty()) line += fmt::format(", {}", rest);
        std::fprintf(stderr, "\r\033[K%s", line.c_str());
    }
    std::fputs("\r\033[K", stderr);
}

}  // namespace

ProgressLine::ProgressLine(const Progress& progress) {
    if (isatty(STDERR_FILENO) == 0) return;
    writing_ = std::jthread([&progress](const std::stop_token& end) { write_lines(progress, end); });
}

ProgressLine::~ProgressLine() = default;

}  // namespace hanei
