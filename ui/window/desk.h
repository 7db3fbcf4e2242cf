/// One workbench with its own ImGui context, drawn frame by frame with OpenGL: what a window and a
/// script share.
#pragma once

#include "ui/panels/workbench.h"
#include "ui/window/input_queue.h"
#include "ui/window/view_textures.h"

#include <memory>

struct ImGuiContext;

namespace hanei {

class Desk {
public:
    struct Setup {
        ProjectContent content;
        std::filesystem::path file;
        ProjectDoor door;
        std::function<void()> wake;  ///< called from another thread when a frame is due
        float scale = 1.0F;          ///< of letters and distances, where the preferences name none
        bool repeatable = false;     ///< show nothing that differs from run to run
        double patience = 60.0;      ///< s a frame waits for a file
    };

    /// Needs     a current OpenGL 3.3 core context with its functions loaded, for the desk's whole life.
    explicit Desk(Setup setup);
    ~Desk();
    Desk(const Desk&) = delete;
    Desk& operator=(const Desk&) = delete;

    InputQueue& input() { return input_; }
    Workbench& workbench() { return *workbench_; }
    const Workbench& workbench() const { return *workbench_; }

    /// Draws into the framebuffer that is bound. `seconds` since the frame before.
    void frame(PixelSize size, float seconds);

    /// A field is edited by typing: keys are text.
    bool wants_text() const;

private:
    ImGuiContext* context_;
    float screen_scale_;
    SceneSnapshot lettered_;  ///< whose texts have their letters
    InputQueue input_;
    std::unique_ptr<ViewTextures> textures_;
    std::unique_ptr<Workbench> workbench_;
};

}  // namespace hanei
