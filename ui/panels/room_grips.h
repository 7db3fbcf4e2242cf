/// Dragging the room's corners, walls, doors and windows in the view.
#pragma once

#include "ui/panels/view_tool.h"

namespace hanei {

/// Holds one grip from press to release.
class GripTool : public ViewTool {
public:
    enum class What { corner, wall, sub_area };

    GripTool(What what, std::size_t index, ObjectId sub_area, SceneSnapshot start, const Vec3& taken_at)
        : what_(what), index_(index), sub_area_(sub_area), start_(std::move(start)), taken_at_(taken_at) {}

    Outcome handle(const PaneSight& sight) override;
    void draw(const PaneSight& sight, WidgetRegistry& widgets) const override;
    std::string hint() const override;

private:
    std::optional<Vec3> pointed(const PaneSight& sight) const;
    std::optional<Scene> edited(const PaneSight& sight, const Vec3& to);

    What what_;
    std::size_t index_;  ///< of the corner or wall
    ObjectId sub_area_;
    SceneSnapshot start_;  ///< when it was taken: every place follows from there
    Vec3 taken_at_{0.0};
    std::string fault_;
    bool begun_ = false;
};

/// Where the handles of the plan stand: only looked at from above.
bool shows_plan_handles(const PaneSight& sight);
Vec3 handle_of_corner(const Room& room, std::size_t corner);
Vec3 handle_of_wall(const Room& room, std::size_t wall);

}  // namespace hanei
