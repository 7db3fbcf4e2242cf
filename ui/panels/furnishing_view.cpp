#include "engine/edit/sub_areas.h"
#include "ui/panels/furnishing.h"
#include "ui/panels/room_grips.h"
#include "ui/panels/sketch.h"
#include "ui/panels/style.h"

#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

constexpr float grip = 11.0F;  // pixels around a handle that take hold of it

std::vector<Vec3> outline_of(const RoomFace& face, const Vec2& low, const Vec2& high) {
    return {face.point(low), face.point({high.x, low.y}), face.point(high), face.point({low.x, high.y})};
}

void draw_face(const PaneSight& sight, const Room& room, int chosen) {
    const std::optional<RoomFace> face = room_face(room, chosen);
    if (!face) return;
    if (chosen >= Room::wall_face(0))
        return sketch::loop(sight.pane, outline_of(*face, face->low, face->high), style::accent, 2.0F);
    std::vector<Vec3> outline;
    for (const Vec2& corner : room.plan) outline.emplace_back(corner, face->origin.z);
    sketch::loop(sight.pane, outline, style::accent, 2.0F);
}

/// Its distances from both ends of the wall, so that it can be placed by eye.
void draw_sub_area(const PaneSight& sight, const Room& room, const SubArea& area, WidgetRegistry& widgets) {
    const std::optional<RoomFace> face = room_face(room, area.face);
    if (!face) return;
    sketch::loop(sight.pane, outline_of(*face, area.low, area.high), style::accent, 2.0F);
    const auto middle = sight.pane.on_screen(face->point(0.5 * (area.low + area.high)));
    if (middle && sight.number == 0)
        widgets.note("area.middle", {middle->x - 4.0F, middle->y - 4.0F, middle->x + 4.0F, middle->y + 4.0F});
    const double y = 0.5 * (area.low.y + area.high.y);
    for (const auto& [from, to] : {std::pair{face->low.x, area.low.x}, std::pair{area.high.x, face->high.x}}) {
        if (to - from < 0.05) continue;
        const Vec3 a = face->point({from, y}), b = face->point({to, y});
        sketch::line(sight.pane, {a, b}, sketch::faint(style::text, 0.7F), 1.0F);
        if (const auto at = sight.pane.on_screen(0.5 * (a + b)))
            sketch::chip(*at, fmt::format("{:.2f}", to - from), style::text);
    }
}

bool is_near(const PaneSight& sight, const Vec3& handle) {
    const auto at = sight.pane.on_screen(handle);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    return at && std::hypot(at->x - mouse.x, at->y - mouse.y) < grip * style::scale();
}

void draw_handles(const PaneSight& sight, WidgetRegistry& widgets) {
    const Room& room = *sight.scene->room;
    for (std::size_t k = 0; k < room.plan.size(); ++k) {
        const Vec3 places[] = {handle_of_wall(room, k), handle_of_corner(room, k)};
        for (const bool corner : {false, true}) {
            const Vec3 place = places[corner ? 1 : 0];
            const auto at = sight.pane.on_screen(place);
            if (!at) continue;
            const bool under = sight.hovered && is_near(sight, place);
            sketch::dot(*at, (corner ? 5.0F : 4.0F) + (under ? 2.0F : 0.0F),
                        corner  ? style::accent
                        : under ? style::accent
                                : style::text);
            if (sight.number == 0)
                widgets.note(fmt::format("room.handle.{}{}", corner ? "corner" : "wall", k + 1),
                             {at->x - 4.0F, at->y - 4.0F, at->x + 4.0F, at->y + 4.0F});
        }
        const auto at = sight.pane.on_screen(places[0]);
        if (!at) continue;
        // The length stands outside of the plan, clear of the handle.
        const Vec2 along = glm::normalize(room.plan[(k + 1) % room.plan.size()] - room.plan[k]);
        const auto off = sight.pane.on_screen(places[0] + Vec3{along.y, -along.x, 0.0});
        if (!off) continue;
        const float length = std::max(1.0F, std::hypot(off->x - at->x, off->y - at->y));
        const float away = 26.0F * style::scale() / length;
        sketch::chip({at->x + away * (off->x - at->x), at->y + away * (off->y - at->y)},
                     fmt::format("{:.2f} m", wall_length(room, k)), style::text);
    }
}

}  // namespace

void Furnishing::draw(const PaneSight& sight, WidgetRegistry& widgets) {
    const Scene& scene = *sight.scene;
    if (!scene.room) return;
    if (sight.selection.primary() == scene.room->id) {
        draw_face(sight, *scene.room, room.face);
        if (shows_plan_handles(sight)) draw_handles(sight, widgets);
    }
    for (const ObjectId id : sight.selection.ids())
        if (const SubArea* const area = find_sub_area(scene, id)) draw_sub_area(sight, *scene.room, *area, widgets);
}

std::unique_ptr<ViewTool> Furnishing::take(const PaneSight& sight) {
    const Scene& scene = *sight.scene;
    if (!scene.room) return nullptr;
    const Ray ray = sight.pane.ray(ImGui::GetIO().MousePos);
    if (shows_plan_handles(sight)) {
        for (std::size_t k = 0; k < scene.room->plan.size(); ++k) {
            const Vec3 corner = handle_of_corner(*scene.room, k), wall = handle_of_wall(*scene.room, k);
            if (is_near(sight, corner))
                return std::make_unique<GripTool>(GripTool::What::corner, k, ObjectId{}, sight.scene, corner);
            if (!is_near(sight, wall)) continue;
            room.face = Room::wall_face(static_cast<int>(k));
            return std::make_unique<GripTool>(GripTool::What::wall, k, ObjectId{}, sight.scene, wall);
        }
    }
    const SubArea* const area = find_sub_area(scene, sight.selection.primary());
    const std::optional<FacePlace> met = face_under(*scene.room, ray.origin, ray.direction);
    if (area == nullptr || !met || sub_area_at(*scene.room, met->face, met->at) != area) return nullptr;
    const Vec3 at = room_face(*scene.room, met->face)->point(met->at);
    return std::make_unique<GripTool>(GripTool::What::sub_area, 0, area->id, sight.scene, at);
}

std::optional<Selection> Furnishing::clicked(const Scene& scene, const Selection& before, const Ray& ray) {
    if (!scene.room) return std::nullopt;
    const std::optional<FacePlace> met = face_under(*scene.room, ray.origin, ray.direction);
    if (!met) return std::nullopt;
    room.message.clear();
    if (const SubArea* const area = sub_area_at(*scene.room, met->face, met->at)) {
        room.face = met->face;
        return Selection(area->id);
    }
    if (before.primary() != scene.room->id) return std::nullopt;
    room.face = met->face;
    return before;
}

}  // namespace hanei
