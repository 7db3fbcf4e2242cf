#include "ui/panels/room_grips.h"

#include "engine/edit/plan_edits.h"
#include "engine/edit/sub_areas.h"
#include "ui/panels/drag.h"
#include "ui/panels/language.h"
#include "ui/panels/sketch.h"
#include "ui/panels/style.h"

#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

constexpr double reach = 1e4;       // m
constexpr double from_above = 0.9;  // cosine: steeper than 26 degrees off the vertical

}  // namespace

bool shows_plan_handles(const PaneSight& sight) {
    return sight.scene->room && sight.selection.primary() == sight.scene->room->id &&
           axes_of(sight.pane.camera).forward.z < -from_above;
}

Vec3 handle_of_corner(const Room& room, std::size_t corner) { return {room.plan[corner], room.floor_height}; }

Vec3 handle_of_wall(const Room& room, std::size_t wall) {
    return {0.5 * (room.plan[wall] + room.plan[(wall + 1) % room.plan.size()]), room.floor_height};
}

/// On the floor for corners and walls, on its own face for a sub-area.
std::optional<Vec3> GripTool::pointed(const PaneSight& sight) const {
    const Ray ray = sight.pane.ray(ImGui::GetIO().MousePos);
    if (what_ != What::sub_area) return on_horizontal_plane(ray, start_->room->floor_height, reach);
    const SubArea* const area = find_sub_area(*start_, sub_area_);
    const std::optional<RoomFace> face = area == nullptr ? std::nullopt : room_face(*start_->room, area->face);
    if (!face) return std::nullopt;
    const double sinks = glm::dot(ray.direction, face->inward);
    if (std::abs(sinks) < 0.02) return std::nullopt;  // seen end on
    return ray.origin + glm::dot(face->origin - ray.origin, face->inward) / sinks * ray.direction;
}

std::optional<Scene> GripTool::edited(const PaneSight& sight, const Vec3& to) {
    const Vec3 by = to - taken_at_;
    const double raster = ImGui::GetIO().KeyCtrl ? (sight.raster > 0.0 ? 0.0 : 0.1) : sight.raster;
    if (what_ == What::sub_area) {
        const SubArea& area = *find_sub_area(*start_, sub_area_);
        const RoomFace face = *room_face(*start_->room, area.face);
        const Vec2 low{snapped(area.low.x + glm::dot(by, face.right), raster),
                       snapped(area.low.y + glm::dot(by, face.up), raster)};
        const Vec2 slide = low - area.low;
        return with_sub_area_moved(*start_, sub_area_, slide.x * face.right + slide.y * face.up);
    }
    const std::vector<Vec2>& plan = start_->room->plan;
    PlanEdit edit;
    if (what_ == What::corner) {
        const Vec2 wished = plan[index_] + Vec2(by);
        edit = with_corner_moved(*start_, index_, {snapped(wished.x, raster), snapped(wished.y, raster)});
    } else {
        const Vec2 along = glm::normalize(plan[(index_ + 1) % plan.size()] - plan[index_]);
        edit = with_wall_moved(*start_, index_, snapped(by.x * along.y - by.y * along.x, raster));
    }
    fault_ = edit.message;
    return std::move(edit.scene);
}

ViewTool::Outcome GripTool::handle(const PaneSight& sight) {
    Outcome outcome;
    begun_ = begun_ || ImGui::IsMouseDragging(ImGuiMouseButton_Left, 4.0F);
    const std::optional<Vec3> to = pointed(sight);
    if (begun_ && to) {
        outcome.scene = edited(sight, *to);
        outcome.step = what_ == What::sub_area ? "Move " + display_name(*start_, sub_area_)
                       : what_ == What::corner ? "Move corner"
                                               : "Move wall";
    }
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        outcome.settles = begun_;
        outcome.finished = true;
    }
    return outcome;
}

std::string GripTool::hint() const {
    return fault_.empty() ? tr("Drag; Ctrl leaves the raster, or keeps to it")
                          : std::string(tr(std::string_view(fault_)));
}

void GripTool::draw(const PaneSight& sight, WidgetRegistry&) const {
    if (fault_.empty() || sight.number != 0) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    sketch::chip({mouse.x, mouse.y + 28.0F * style::scale()}, std::string(tr(std::string_view(fault_))),
                 style::warning);
}

}  // namespace hanei
