/// Where the widgets of the last frame were: what scripts and tests aim at by name.
#pragma once

#include <map>
#include <string>

namespace hanei {

/// A rectangle on the screen, in pixels from the top left.
struct ScreenRect {
    float left = 0.0F, top = 0.0F, right = 0.0F, bottom = 0.0F;
    float x() const { return 0.5F * (left + right); }
    float y() const { return 0.5F * (top + bottom); }
};

class WidgetRegistry {
public:
    void begin_frame() { rects_.clear(); }

    /// Notes the ImGui item drawn last.
    void note(const std::string& name);
    void note(const std::string& name, const ScreenRect& rect) { rects_[name] = rect; }

    /// Null when no widget of that name was drawn. Good until the next frame.
    const ScreenRect* find(const std::string& name) const;
    const std::map<std::string, ScreenRect>& all() const { return rects_; }

private:
    std::map<std::string, ScreenRect> rects_;
};

}  // namespace hanei
