/// One picture on the screen: where it is, and how places of the room come there.
#pragma once

#include "ui/view/camera.h"

#include <imgui.h>
#include <optional>
#include <vector>

namespace hanei {

/// In pixels from the screen's top left.
struct Pane {
    float left = 0.0F, top = 0.0F, width = 0.0F, height = 0.0F;
    Camera camera;

    bool holds(ImVec2 at) const;
    Vec2 within(ImVec2 at) const;  ///< 0 to 1 from its top left
    double aspect() const { return height > 0.0F ? static_cast<double>(width / height) : 1.5; }

    std::optional<ImVec2> on_screen(const Vec3& place) const;  ///< empty behind the eye
    Ray ray(ImVec2 at) const { return ray_through(camera, within(at), aspect()); }

    /// A line through these places, in pieces where it passes behind the eye.
    std::vector<std::vector<ImVec2>> on_screen(const std::vector<Vec3>& places) const;
};

}  // namespace hanei
