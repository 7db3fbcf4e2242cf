/// Accuracy against time in the window: the runs as a plot whose points can be used, the presets with what
/// they are predicted to take and to be off by.
#pragma once

#include "engine/study/sweep.h"
#include "ui/panels/task_bar.h"
#include "ui/panels/user_door.h"
#include "ui/panels/widget_registry.h"

#include <functional>
#include <memory>
#include <optional>

namespace hanei {

class StudyPanel {
public:
    StudyPanel();
    ~StudyPanel();

    /// Where predictions come from and what is learned goes to; and who wants a frame when there is news.
    void connect(const UserDoor& door, std::function<void()> wake);

    struct Outcome {
        bool starts = false;
        std::optional<Settings> use{};  ///< of the point that was clicked
    };
    /// The content of its tab.
    Outcome table(const SceneSnapshot& scene, const Settings& present, bool measured, WidgetRegistry& widgets);

    /// Runs in the background; what was found before a cancel stays.
    void start(const SceneSnapshot& scene, const Settings& settings);
    void cancel();
    void follow();  ///< once a frame
    bool busy() const;
    Task task();  ///< while it is busy

    const Sweep& sweep() const;              ///< what is known so far
    const Calibration& calibration() const;  ///< of this machine

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace hanei
