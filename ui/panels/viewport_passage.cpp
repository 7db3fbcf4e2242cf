#include "ui/panels/viewport.h"
#include "ui/view/camera_passage.h"

#include <algorithm>

namespace hanei {
namespace {

constexpr double longest_frame = 0.05;  // s: before the first one the window may have slept

/// Slow at both ends.
double eased(double share) { return share * share * (3.0 - 2.0 * share); }

}  // namespace

Camera Viewport::present_camera() const {
    return passage_ ? between(passage_->from, state.camera, eased(passage_->share)) : state.camera;
}

/// Begins where the picture is, be it on its way already; ends with the time, or when another picture
/// becomes the active one.
void Viewport::follow_passage() {
    const bool same_picture =
        passage_ && passage_->layout == state.panes.layout() && passage_->active == state.panes.active();
    if (passage_)
        passage_->share +=
            std::min(longest_frame, static_cast<double>(ImGui::GetIO().DeltaTime)) / std::max(1e-3, passage_seconds);
    if (passage_ && (!same_picture || passage_->share >= 1.0)) passage_.reset();
    if (!state.came_from) return;
    // Where it was going to is where it would have come from.
    const Camera from = passage_ ? between(passage_->from, *state.came_from, eased(passage_->share)) : *state.came_from;
    state.came_from.reset();
    passage_.reset();
    if (passage_seconds > 0.0 && from != state.camera && can_glide(from, state.camera))
        passage_ = Passage{from, 0.0, state.panes.layout(), state.panes.active()};
}

}  // namespace hanei
