/// Studies in the background.
#pragma once

#include "engine/study/study.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace hanei {

/// Runs studies one at a time on a thread of its own. Every member is for the UI thread alone.
/// In goes a snapshot, out comes a finished Solution; nothing else is ever shared.
class Job {
public:
    /// `wake` is called from the job's thread when something new can be taken.
    explicit Job(std::function<void()> wake);
    ~Job();

    /// The newest request wins: what runs is stopped within a tile's time.
    void start(SceneSnapshot scene, const Settings& settings, const StudyRequest& request);
    void cancel();            ///< ends the running study and forgets the waiting one
    SolutionSnapshot take();  ///< once a frame; null when there is none new
    bool busy() const;        ///< something runs or waits
    const Progress& progress() const { return progress_; }

    /// A place whose light is to be divided by where it came from.
    struct Question {
        SolutionSnapshot solution;
        Vec3 position{0.0};
        Vec3 normal{0.0, 0.0, 1.0};  ///< unit
    };
    /// Worked on when no study waits; the newest question wins, and a study that is started ends it.
    void ask(Question question);
    std::shared_ptr<const Contributions> take_contributions();  ///< once a frame; null when there are none new

    /// What went wrong on the machine (memory) in the last study; empty when nothing did.
    std::string take_failure();

private:
    struct Request {
        SceneSnapshot scene;
        Settings settings;
        StudyRequest wanted;
    };

    void serve(const std::stop_token& end);
    void answer(Study& study, const Question& question, const std::stop_token& stop);
    void post(SolutionSnapshot solution);

    Progress progress_;
    std::function<void()> wake_;
    mutable std::mutex guard_;  ///< of everything below
    std::condition_variable_any arrived_;
    std::optional<Request> waiting_;
    std::optional<Question> question_;
    std::shared_ptr<const Contributions> contributions_;
    std::stop_source running_;
    bool is_running_ = false;
    SolutionSnapshot finished_;
    std::string failure_;
    std::jthread thread_;  ///< last: it ends before what it uses
};

}  // namespace hanei
