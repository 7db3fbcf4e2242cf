/// Drives a desk without a window: aims at widgets by name and at objects by place, in made-up time,
/// so that two runs give the same pictures bit for bit.
#pragma once

#include "ui/view/offscreen.h"
#include "ui/window/desk.h"
#include "ui/window/recorder.h"

#include <condition_variable>
#include <functional>
#include <mutex>

namespace hanei {

/// Keys that are held while something is clicked or dragged.
struct HeldKeys {
    bool control = false, shift = false, alt = false;
};

class Driver {
public:
    struct Setup {
        ProjectContent content;
        std::filesystem::path file;
        ProjectDoor door;
        PixelSize size{1280, 800};
        float scale = 1.0F;
        double patience = 60.0;  ///< s a frame waits for a file: scripts need not wait themselves
    };

    /// Throws std::runtime_error when there is no OpenGL without a display.
    explicit Driver(Setup setup);
    ~Driver();

    Workbench& workbench() { return desk_->workbench(); }
    const Workbench& workbench() const { return desk_->workbench(); }

    void frames(int count);

    /// Frames until the shown scene's complete answer is on the screen. False after `seconds`.
    bool wait_settled(double seconds = 120.0);
    /// Plays frames until it is so; false when it is not in time.
    bool wait_until(const std::function<bool()>& so, double seconds = 120.0);

    // Each returns what went wrong, or nothing.
    using Fault = std::string;
    using Held = HeldKeys;
    Fault click(const std::string& widget, int button = 0, Held held = {});
    Fault double_click(const std::string& widget);
    Fault point_at(const std::string& widget);
    Fault drag(const std::string& widget, float dx, float dy);                      ///< pixels
    Fault click_object(const std::string& object, int button = 0, Held held = {});  ///< where it is seen
    Fault double_click_object(const std::string& object);
    Fault point_at_object(const std::string& object);
    /// A drag over the picture from one place to another, in pixels from the window's top left.
    void drag_over(ImVec2 from, ImVec2 to, Held held = {});
    void move_by(float dx, float dy);                              ///< the pointer, whatever is held
    Fault drag_object(const std::string& object, const Vec3& by);  ///< metres: in the plan, or by the z arrow
    /// The same within `seconds` of real time, 60 frames a second if they can be had, as a hand does it.
    Fault drag_object(const std::string& object, const Vec3& by, double seconds);
    Fault press(std::string_view chord, double seconds = 0.0);  ///< held for so long, in made-up time
    void type(std::string_view text);
    void wheel(float notches);
    void point_at(float x, float y);
    void drop(std::vector<std::filesystem::path> files, float x, float y);
    Fault drop_on_object(std::vector<std::filesystem::path> files, const std::string& object);
    void button(int which, bool down);

    Image picture() const;  ///< of the last frame

    /// Notes every frame from here on; null: no more.
    void record(Recorder* recorder) { recorder_ = recorder; }

private:
    std::optional<ImVec2> object_on_screen(const std::string& object) const;
    bool is_free(ImVec2 at) const;
    void hold(Held held, bool down);
    void twice();  ///< a double click where the pointer is
    void run_queue();
    void drag_path(ImVec2 from, ImVec2 to, double seconds);

    std::mutex mutex_;
    std::condition_variable wakes_;
    bool woken_ = false;
    OffscreenContext context_;
    PixelSize size_;
    unsigned framebuffer_ = 0;
    unsigned colour_ = 0;
    std::unique_ptr<Desk> desk_;
    Recorder* recorder_ = nullptr;
};

}  // namespace hanei
