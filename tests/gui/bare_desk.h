/// A workbench in an ImGui context of its own, without OpenGL: frames cost a millisecond, nothing is
/// painted in the view, and input goes through the window's own queue.
#pragma once

#include "ui/panels/workbench.h"
#include "ui/window/input_queue.h"

#include <memory>

struct ImGuiContext;

namespace hanei {

class BareDesk {
public:
    BareDesk(ProjectContent content, ProjectDoor door, ImVec2 size = {1280.0F, 800.0F}, Workbench::Options how = {true},
             float scale = 1.0F, Language language = Language::english);
    ~BareDesk();
    BareDesk(const BareDesk&) = delete;
    BareDesk& operator=(const BareDesk&) = delete;

    InputQueue& input() { return input_; }
    Workbench& workbench() { return *workbench_; }
    const Workbench& workbench() const { return *workbench_; }

    void frame();
    void run_queue();  ///< frames until all input was taken, and one for what follows from it

private:
    ImGuiContext* context_;
    InputQueue input_;
    std::unique_ptr<Workbench> workbench_;
};

}  // namespace hanei
