/// The exact picture in the window: painted in the background, shown when it is done.
#pragma once

#include "ui/panels/exact_room.h"
#include "ui/panels/task_bar.h"
#include "ui/panels/time_left.h"
#include "ui/panels/view_painter.h"
#include "ui/panels/widget_registry.h"
#include "ui/view/offscreen.h"

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace hanei {

/// One picture at a time, of the solution it was started with: what is edited meanwhile does not
/// reach it. Every member is for the UI thread alone.
class ExactPanel {
public:
    /// `wake` is called from the painting thread when the picture is done.
    explicit ExactPanel(std::function<void()> wake) : wake_(std::move(wake)) {}
    ~ExactPanel() { cancel(); }

    /// What ran before is stopped, what was shown is put away.
    void start(SolutionSnapshot solution, PictureRequest request);
    void cancel();  ///< waits for a tile's rays at most
    bool busy() const { return painting_.joinable(); }
    std::string take_failure() { return std::exchange(shown_failure_, {}); }  ///< empty when nothing went wrong
    const Image* shown() const { return shown_ ? &*shown_ : nullptr; }

    Task task();  ///< while it is busy

    /// Draws the picture; `save` is called when the user wants to keep it.
    void draw(const ViewPainter& paint, const std::function<void()>& save, WidgetRegistry& widgets);

    /// Letters a picture that is done. Needs an OpenGL context.
    void after_frame();

private:
    void draw_picture(const ViewPainter& paint, const std::function<void()>& save, WidgetRegistry& widgets);

    std::function<void()> wake_;
    SolutionSnapshot solution_;
    PictureRequest request_;
    Progress progress_;
    TimeLeft left_;
    std::optional<Image> shown_;
    std::string shown_failure_;
    long number_ = 0;  ///< of the picture: the screen's copy is renewed when it changes

    std::mutex guard_;  ///< of what the painting thread hands over
    std::shared_ptr<const ExactPicture> room_;
    std::string failure_;
    bool done_ = false;
    std::jthread painting_;  ///< last: it ends before what it uses
};

}  // namespace hanei
