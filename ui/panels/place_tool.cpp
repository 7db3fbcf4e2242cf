#include "ui/panels/place_tool.h"

#include "engine/edit/furniture_edits.h"
#include "engine/edit/plan_shape.h"
#include "engine/edit/standing.h"
#include "engine/scene/faces.h"
#include "ui/panels/drag.h"
#include "ui/panels/language.h"
#include "ui/panels/sketch.h"
#include "ui/panels/style.h"
#include "ui/view/pick.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace hanei {
namespace {

constexpr double reach = 1e4;         // m
constexpr double near_a_wall = 0.35;  // m between back and wall: nearer than that it stands against it
constexpr double quarter = 0.5 * std::numbers::pi;

bool pressed(Key key) { return ImGui::IsKeyPressed(static_cast<int>(key), false); }

std::string name_of_model(const FurnitureModel& model) {
    const FurnitureKind* const kind = find_furniture_kind(model.kind);
    return kind == nullptr ? model.kind : std::string(tr(kind->label));
}

}  // namespace

bool PlaceTool::takes(const Chord& chord) const {
    if (chord.alt) return false;
    return chord.key == Key::enter || chord.key == Key::keypad_enter || (chord.key == key_of('R') && !chord.control);
}

std::string PlaceTool::hint() const {
    return fmt::format("{}: {}", name_of_model(model_),
                       dragged_ ? tr("let go to place it. R turns it")
                                : tr("click to place it, Ctrl+click for several. R turns it, Esc leaves"));
}

void PlaceTool::aim(const PaneSight& sight) {
    const FurnitureKind& kind = *find_furniture_kind(model_.kind);
    const double floor = sight.scene->room ? sight.scene->room->floor_height : 0.0;
    const Ray ray = sight.pane.ray(ImGui::GetIO().MousePos);
    std::optional<Vec3> met = on_horizontal_plane(ray, floor, reach);
    if (kind.stands_on_furniture) {
        const std::optional<FaceHit> top = first_face(*sight.scene, ray);
        if (top && top->normal.z > 0.99) met = top->place;
    }
    if (!met) return;
    at_ = Vec3{snapped(met->x, sight.raster), snapped(met->y, sight.raster), met->z};
    Added added = with_furniture(*sight.scene, model_, *at_, rotation_);
    if (!turned_ && !kind.stands_on_furniture) {
        if (const auto stood = against_wall(added.scene, added.object, near_a_wall)) {
            added.scene = *stood;
            const Furniture& piece = added.scene.furniture.back();
            at_ = piece.position;
            rotation_ = piece.rotation;
        }
    }
    stands_free_ = stands_clear(added.scene, added.object);
    ghost_.emplace();
    ghost_->furniture.push_back(added.scene.furniture.back());
}

ViewTool::Outcome PlaceTool::place(const PaneSight& sight) {
    Outcome outcome;
    Added added = with_furniture(*sight.scene, model_, *at_, rotation_);
    outcome.chosen = Selection(added.object);
    outcome.scene = std::move(added.scene);
    outcome.step = "Add " + std::string(find_furniture_kind(model_.kind)->label);
    outcome.settles = true;
    outcome.finished = dragged_ || !ImGui::GetIO().KeyCtrl;
    return outcome;
}

ViewTool::Outcome PlaceTool::handle(const PaneSight& sight) {
    Outcome outcome;
    if (pressed(key_of('R'))) {
        turned_ = true;
        rotation_ = std::remainder(rotation_ + (ImGui::GetIO().KeyShift ? quarter / 6.0 : quarter), 4.0 * quarter);
    }
    const bool over = sight.pane.holds(ImGui::GetIO().MousePos) && (dragged_ || sight.hovered);
    if (over) aim(sight);
    if (dragged_ && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        if (over && at_) return place(sight);
        outcome.finished = true;
        return outcome;
    }
    const bool enter = pressed(Key::enter) || pressed(Key::keypad_enter);
    const bool clicked = !dragged_ && sight.hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    if (at_ && (enter || clicked)) return place(sight);
    return outcome;
}

void PlaceTool::draw(const PaneSight& sight, WidgetRegistry& widgets) const {
    if (!ghost_ || !at_) return;
    const ImU32 colour = stands_free_ ? style::accent : style::warning;
    for (const Face& face : faces_of(*ghost_)) sketch::loop(sight.pane, face.region.outline, colour, 1.2F);
    const Bounds bounds = bounds_of(*ghost_);
    const double z = bounds.low.z;
    sketch::fill(sight.pane,
                 {{bounds.low.x, bounds.low.y, z},
                  {bounds.high.x, bounds.low.y, z},
                  {bounds.high.x, bounds.high.y, z},
                  {bounds.low.x, bounds.high.y, z}},
                 sketch::faint(colour, 0.15F));
    const auto middle = sight.pane.on_screen(*at_);
    if (!middle || sight.number != 0) return;
    widgets.note("place.ghost", {middle->x - 5.0F, middle->y - 5.0F, middle->x + 5.0F, middle->y + 5.0F});
    sketch::chip({middle->x, middle->y + 24.0F * style::scale()}, fmt::format("{:.2f}  {:.2f} m", at_->x, at_->y),
                 style::text);
}

}  // namespace hanei
