#include "ui/panels/walk_tool.h"

#include "ui/panels/language.h"
#include "ui/panels/sketch.h"
#include "ui/panels/style.h"
#include "ui/panels/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hanei {
namespace {

constexpr double pace = 1.4;              // m/s
constexpr double hurry = 2.5;             // times as fast with Shift
constexpr double turn_pace = 1.3;         // rad/s
constexpr double rise_pace = 0.8;         // m/s of the eye's height
constexpr double notch = 0.3;             // m a notch of the wheel
constexpr double look_rate = 0.004;       // rad a pixel at scale 1
constexpr double first_frame = 1.0 / 60;  // s: before it the window may have slept for minutes
constexpr double longest_frame = 0.25;    // s: after a stall nobody leaps
constexpr float click_slack = 4.0F;       // pixels
constexpr double walking_field_of_view = 60.0 / 180.0 * std::numbers::pi;  // rad: a longer lens shows a wall alone

struct WalkKey {
    Key key;
    Vec2 along;  ///< ahead, to the right
    double turn, rise;
};
constexpr std::array walk_keys{
    WalkKey{key_of('W'), {1.0, 0.0}, 0.0, 0.0},     WalkKey{key_of('S'), {-1.0, 0.0}, 0.0, 0.0},
    WalkKey{key_of('A'), {0.0, -1.0}, 0.0, 0.0},    WalkKey{key_of('D'), {0.0, 1.0}, 0.0, 0.0},
    WalkKey{Key::up, {1.0, 0.0}, 0.0, 0.0},         WalkKey{Key::down, {-1.0, 0.0}, 0.0, 0.0},
    WalkKey{Key::left, {0.0, 0.0}, 1.0, 0.0},       WalkKey{Key::right, {0.0, 0.0}, -1.0, 0.0},
    WalkKey{key_of('Q'), {0.0, 0.0}, 0.0, -1.0},    WalkKey{key_of('E'), {0.0, 0.0}, 0.0, 1.0},
    WalkKey{Key::page_down, {0.0, 0.0}, 0.0, -1.0}, WalkKey{Key::page_up, {0.0, 0.0}, 0.0, 1.0},
};

bool keys_are_meant() {
    const ImGuiIO& io = ImGui::GetIO();
    return !io.WantTextInput && !io.KeyCtrl && !io.KeyAlt &&
           !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

void step(Walker& walker, const Scene& scene, const Vec2& along, bool& is_held) {
    const Vec2 ahead(std::cos(walker.heading), std::sin(walker.heading)), right(ahead.y, -ahead.x);
    const Step taken = stepped(scene, Vec2(walker.eye), along.x * ahead + along.y * right);
    walker.eye.x = taken.place.x;
    walker.eye.y = taken.place.y;
    is_held = taken.is_held;
}

}  // namespace

WalkTool::WalkTool(ViewState& state, const Scene& scene) : state_(state) {
    Camera camera = seen_by(entering(scene, state_.camera), state_.camera);
    camera.field_of_view = std::max(camera.field_of_view, walking_field_of_view);
    camera.left_out = {};
    state_.go_to(camera);
}

void WalkTool::look(Walker& walker) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!looks_ || (!io.MouseDown[ImGuiMouseButton_Left] && !io.MouseDown[ImGuiMouseButton_Right])) return;
    const double rate = look_rate / static_cast<double>(style::scale());
    walker.turn(-rate * static_cast<double>(io.MouseDelta.x), -rate * static_cast<double>(io.MouseDelta.y));
}

void WalkTool::walk(Walker& walker, const PaneSight& sight) {
    const ImGuiIO& io = ImGui::GetIO();
    Vec2 along(0.0);
    double turn = 0.0, rise = 0.0;
    bool any = false;
    for (const WalkKey& each : walk_keys) {
        if (!keys_are_meant() || !ImGui::IsKeyDown(static_cast<int>(each.key))) continue;
        any = true;
        along += each.along;
        turn += each.turn;
        rise += each.rise;
    }
    const double passed = static_cast<double>(io.DeltaTime);
    const double seconds = std::min(passed, moves_ ? longest_frame : first_frame);
    moves_ = any;
    const Scene& scene = *sight.scene;
    walker.turn(seconds * turn_pace * turn, 0.0);
    const double floor = floor_of(scene);
    if (rise != 0.0) walker.eye.z = floor + eye_heights(scene).kept(walker.eye.z - floor + seconds * rise_pace * rise);
    const double metres = seconds * pace * (io.KeyShift ? hurry : 1.0);
    if (const double length = glm::length(along); length > 0.0)
        step(walker, scene, metres / length * along, is_held_);
    else if (sight.hovered && io.MouseWheel != 0.0F)
        step(walker, scene, {notch * static_cast<double>(io.MouseWheel), 0.0}, is_held_);
    else if (any || io.MouseDelta.x != 0.0F)
        is_held_ = false;
}

ViewTool::Outcome WalkTool::handle(const PaneSight& sight) {
    Outcome outcome;
    const ImGuiIO& io = ImGui::GetIO();
    outcome.finished = state_.camera.orthographic;
    if (outcome.finished) return outcome;
    const bool pressed = ImGui::IsMouseClicked(ImGuiMouseButton_Left) || ImGui::IsMouseClicked(ImGuiMouseButton_Right);
    if (pressed) {
        looks_ = sight.hovered;
        pressed_at_ = io.MousePos;
    }
    const bool stayed = std::hypot(io.MousePos.x - pressed_at_.x, io.MousePos.y - pressed_at_.y) < click_slack;
    outcome.finished = looks_ && stayed && ImGui::IsMouseReleased(ImGuiMouseButton_Right);
    const Walker before = walker_of(state_.camera);
    Walker walker = before;
    look(walker);
    walk(walker, sight);
    if (walker.eye != before.eye || walker.heading != before.heading || walker.pitch != before.pitch)
        state_.camera = seen_by(walker, state_.camera);
    return outcome;
}

bool WalkTool::takes(const Chord& chord) const {
    if (chord.control || chord.alt) return false;
    return std::any_of(walk_keys.begin(), walk_keys.end(), [&](const WalkKey& each) { return each.key == chord.key; });
}

std::string WalkTool::readout(const Scene& scene) const {
    std::string text = say("Eye {} above the floor", with_unit(state_.camera.eye.z - floor_of(scene), "m", 2));
    if (is_held_) text += std::string("  ·  ") + tr("the wall is in the way");
    return text;
}

void WalkTool::draw(const PaneSight& sight, WidgetRegistry& widgets) const {
    const Pane& pane = sight.pane;
    const float scale = style::scale();
    if (sight.number == state_.panes.active()) {
        const ImVec2 at{pane.left + 0.5F * pane.width, pane.top + pane.height - 24.0F * scale};
        const std::string text = readout(*sight.scene);
        sketch::chip(at, text, is_held_ ? ImU32(style::warning) : ImU32(style::text));
        const ImVec2 half{0.5F * ImGui::CalcTextSize(text.c_str()).x, 0.5F * ImGui::GetTextLineHeight()};
        widgets.note("walk.readout", {at.x - half.x, at.y - half.y, at.x + half.x, at.y + half.y});
        return;
    }
    // Beside it, where the walker stands and looks.
    const Walker walker = walker_of(state_.camera);
    constexpr double gaze = 1.2, half_angle = 0.45;  // m, rad
    const auto towards = [&](double turn) {
        return walker.eye + gaze * Vec3(std::cos(walker.heading + turn), std::sin(walker.heading + turn), 0.0);
    };
    sketch::line(pane, {towards(-half_angle), walker.eye, towards(half_angle)}, style::accent, 1.6F);
    if (const auto at = pane.on_screen(walker.eye)) sketch::dot(*at, 4.5F, style::accent);
}

std::string WalkTool::hint() const {
    return tr("W A S D or arrows walk, drag to look, Shift faster, Q E eye height; Esc or right click ends");
}

}  // namespace hanei
