/// The light along a line of the room, as curves.
#pragma once

#include "engine/study/profile.h"
#include "ui/panels/view_tool.h"

#include <optional>

namespace hanei {

class ProfilePanel : public ViewOverlay {
public:
    const std::optional<ProfileLine>& line() const { return line_; }
    void set_line(std::optional<ProfileLine> line) { line_ = line; }
    void forget() { *this = ProfilePanel(); }

    struct Outcome {
        bool draws_line = false;  ///< the user wants to draw one in the view
        bool exports = false;     ///< as CSV
    };
    /// The content of its tab; takes a few values more of the solution.
    Outcome table(const SolutionSnapshot& solution, WidgetRegistry& widgets);

    const std::optional<ProfileSampler>& sampler() const { return sampler_; }
    bool is_busy() const { return sampler_ && !sampler_->done(); }  ///< while its tab is drawn, frames are wanted

    /// The line, with the place that the pointer is at in the plot.
    void draw(const PaneSight& sight, WidgetRegistry& widgets) override;

    void begin_frame() { was_drawn_ = false; }

private:
    void fields(Outcome& outcome, WidgetRegistry& widgets);
    void plot(WidgetRegistry& widgets);

    std::optional<ProfileLine> line_;
    std::optional<ProfileSampler> sampler_;
    Vec3 asked_normal_{0.0};         ///< of the sampler's line, as it was given
    std::optional<double> pointed_;  ///< m along the line
    bool was_drawn_ = false;         ///< the tab, in this frame
};

/// Draws the line: from where the button is pressed to where it is let go, on that surface's plane.
class ProfileTool : public ViewTool {
public:
    explicit ProfileTool(ProfilePanel& panel) : panel_(panel) {}

    Outcome handle(const PaneSight& sight) override;
    void draw(const PaneSight& sight, WidgetRegistry& widgets) const override;
    std::string hint() const override;

private:
    ProfilePanel& panel_;
    std::optional<ProfileLine> begun_;
};

}  // namespace hanei
