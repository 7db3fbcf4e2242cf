#include "ui/window/recorder.h"

#include "engine/base/whole_file.h"

#include <algorithm>
#include <fmt/format.h>

namespace hanei {
namespace {

std::string figures(std::string_view name, std::vector<double> seconds) {
    if (seconds.empty()) return fmt::format("{}: none\n", name);
    std::sort(seconds.begin(), seconds.end());
    const auto at = [&](std::size_t percent) {
        return 1000.0 * seconds[std::min(seconds.size() - 1, seconds.size() * percent / 100)];
    };
    return fmt::format("{}: {}, p50 {:.1f} ms, p95 {:.1f} ms, longest {:.1f} ms\n", name, seconds.size(), at(50),
                       at(95), at(100));
}

}  // namespace

Recorder::Recorder(std::filesystem::path folder, int every) : folder_(std::move(folder)), every_(every) {}

void Recorder::note(double frame_seconds, const LiveStudy& study, Image picture) {
    const LiveStudy::Delay shown = study.picture_delay(), answered = study.answer_delay();
    if (has_begun_ && shown.count != pictures_seen_) picture_seconds_.push_back(shown.seconds);
    if (has_begun_ && answered.count != answers_seen_) answer_seconds_.push_back(answered.seconds);
    pictures_seen_ = shown.count;
    answers_seen_ = answered.count;
    has_begun_ = true;
    frame_seconds_.push_back(frame_seconds);
    if (!picture.rgba.empty())
        shots_.push_back({frames_, std::chrono::duration<double>(Clock::now() - begun_).count(), std::move(picture)});
    ++frames_;
}

void Recorder::write() const {
    if (const auto reason = make_folder(folder_)) throw std::runtime_error(folder_.string() + ": " + *reason);
    for (const Shot& shot : shots_)
        write_png(shot.image, folder_ / fmt::format("frame-{:05}-{:07.3f}s.png", shot.frame, shot.seconds));
}

std::string Recorder::report() const {
    return figures("frames", frame_seconds_) + figures("pictures with direct light", picture_seconds_) +
           figures("answers", answer_seconds_);
}

}  // namespace hanei
