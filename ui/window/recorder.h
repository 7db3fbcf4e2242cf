/// What a person would have seen while something was dragged: pictures of frames, how long frames took
/// and how long answers.
#pragma once

#include "ui/panels/live_study.h"
#include "ui/view/image.h"

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace hanei {

class Recorder {
public:
    /// Every `every`th frame from here on.
    Recorder(std::filesystem::path folder, int every);

    bool wants_picture() const { return frames_ % every_ == 0; }
    /// Of the frame just drawn; `picture` is empty unless it was wanted.
    void note(double frame_seconds, const LiveStudy& study, Image picture);

    /// Writes the pictures, each named by its frame and its time; throws std::runtime_error when the
    /// disk refuses. Pictures wait in memory until here, so that writing them delays no frame.
    void write() const;

    /// Half and 95 of 100 of the frames, of the pictures with direct light as it is and of the complete
    /// answers took no longer than this; with their numbers and the longest.
    std::string report() const;

private:
    using Clock = std::chrono::steady_clock;
    struct Shot {
        int frame = 0;
        double seconds = 0.0;
        Image image;
    };

    std::filesystem::path folder_;
    int every_ = 1;
    int frames_ = 0;
    Clock::time_point begun_ = Clock::now();
    std::vector<double> frame_seconds_, picture_seconds_, answer_seconds_;
    std::size_t pictures_seen_ = 0, answers_seen_ = 0;
    bool has_begun_ = false;
    std::vector<Shot> shots_;
};

}  // namespace hanei
