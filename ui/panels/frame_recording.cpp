#include "ui/panels/frame_recording.h"

#include "engine/base/whole_file.h"
#include "ui/panels/language.h"

#include <ctime>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <stdexcept>
#include <utility>

namespace hanei {

std::optional<std::string> FrameRecording::start(const std::filesystem::path& where, const std::string& name) {
    writing_.request_stop();
    if (writing_.joinable()) writing_.join();
    const std::time_t seconds = std::time(nullptr);
    std::tm local{};
    localtime_r(&seconds, &local);
    folder_ = where / fmt::format("{} recording {:%Y-%m-%d %H-%M-%S}", name, local);
    if (const auto reason = make_folder(folder_)) return folder_.string() + ": " + *reason;
    begun_ = std::chrono::steady_clock::now();
    taken_ = left_out_ = 0;
    index_ = "frame,file,seconds,shows\n";
    fault_.clear();
    ended_ = false;
    is_on_ = true;
    writing_ = std::jthread([this](const std::stop_token& wish) { run(wish); });
    return std::nullopt;
}

FrameRecording::~FrameRecording() {
    writing_.request_stop();
    if (writing_.joinable()) writing_.join();
}

void FrameRecording::stop(double patience) {
    if (!is_on_) return;
    is_on_ = false;
    writing_.request_stop();
    std::unique_lock lock(guard_);
    filled_.wait_for(lock, std::chrono::duration<double>(patience), [this] { return ended_; });
}

bool FrameRecording::has_ended() {
    const std::scoped_lock lock(guard_);
    return ended_;
}

bool FrameRecording::take_end() {
    if (!is_writing() || !has_ended()) return false;
    writing_.join();
    return true;
}

Task FrameRecording::task() {
    const std::scoped_lock lock(guard_);
    return {"writing", say("Writing {} pictures", waiting_.size()), 0.0F, {}, [this] {
                const std::scoped_lock inside(guard_);
                left_out_ += waiting_.size();
                waiting_.clear();
                waiting_bytes_ = 0;
            }};
}

void FrameRecording::take(Image picture, std::string what) {
    constexpr std::size_t most_bytes = std::size_t{512} << 20U;
    if (picture.rgba.empty()) return;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
    const std::scoped_lock lock(guard_);
    if (waiting_bytes_ + picture.rgba.size() > most_bytes) {
        ++left_out_;
        return;
    }
    waiting_bytes_ += picture.rgba.size();
    waiting_.push_back({++taken_, seconds, std::move(what), std::move(picture)});
    filled_.notify_all();
}

std::string FrameRecording::take_fault() {
    const std::scoped_lock lock(guard_);
    return std::exchange(fault_, {});
}

std::string FrameRecording::write(const Frame& frame) {
    const std::string name = fmt::format("frame-{:05}.png", frame.number);
    try {
        write_png(frame.image, folder_ / name);
    } catch (const std::runtime_error& fault) {
        return fault.what();
    }
    std::string what = frame.what;
    for (char& letter : what)
        if (letter == '"' || letter == '\n') letter = '\'';
    index_ += fmt::format("{},{},{:.3f},\"{}\"\n", frame.number, name, frame.seconds, what);
    return {};
}

/// Until the recording is stopped and nothing waits, or the disk refuses.
void FrameRecording::run(const std::stop_token& stop) {
    std::string fault;
    std::unique_lock lock(guard_);
    while (fault.empty()) {
        filled_.wait(lock, stop, [this] { return !waiting_.empty(); });
        if (waiting_.empty()) break;
        const Frame frame = std::move(waiting_.front());
        waiting_.pop_front();
        waiting_bytes_ -= frame.image.rgba.size();
        lock.unlock();
        fault = write(frame);
        lock.lock();
    }
    waiting_.clear();
    waiting_bytes_ = 0;
    if (left_out_ > 0) index_ += fmt::format(",,,\"{} pictures were left out\"\n", left_out_);
    if (const auto reason = write_whole_file(folder_ / "index.csv", index_); reason && fault.empty())
        fault = (folder_ / "index.csv").string() + ": " + *reason;
    fault_ = fault;
    ended_ = true;
    filled_.notify_all();
}

}  // namespace hanei
