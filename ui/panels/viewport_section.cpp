#include "ui/panels/form.h"
#include "ui/panels/language.h"
#include "ui/panels/section.h"
#include "ui/panels/style.h"
#include "ui/panels/viewport.h"

#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

constexpr float grip = 9.0F;  // pixels about the handle
constexpr ImU32 shade = IM_COL32(0, 0, 0, 150);

/// The plane's outline across the bounds of the room; its normal lies along an axis or close to one.
std::vector<Vec3> outline_of(const Cut& cut, const Bounds& bounds) {
    const Vec3 size = glm::abs(cut.normal);
    const int across = size.z >= std::max(size.x, size.y) ? 2 : size.y >= size.x ? 1 : 0;
    const int u = (across + 1) % 3, v = (across + 2) % 3;
    std::vector<Vec3> places;
    for (const auto& [right, high] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}) {
        Vec3 place = handle_of(cut, bounds);
        place[u] = right != 0 ? bounds.high[u] : bounds.low[u];
        place[v] = high != 0 ? bounds.high[v] : bounds.low[v];
        places.push_back(place);
    }
    return places;
}

}  // namespace

/// The plane as a frame, and an arrow on it that is dragged; it points to what is left out.
void Viewport::draw_section(const Input& input, int k, WidgetRegistry& widgets) {
    const Pane pane = state.panes.pane(k);
    if (!pane.camera.left_out.cut) return;
    const Cut cut = *pane.camera.left_out.cut;
    const Bounds bounds = bounds_of(*input.scene);
    draw_line(pane, outline_of(cut, bounds), style::accent, 1.2F);
    const Vec3 place = handle_of(cut, bounds);
    const auto foot = pane.on_screen(place);
    const auto tip = pane.on_screen(place + 0.09 * picture_height_at(pane.camera, place) * cut.normal);
    const float scale = style::scale();
    if (!foot || !tip || std::hypot(tip->x - foot->x, tip->y - foot->y) < 8.0F * scale) return;  // seen end on
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddLine(*foot, *tip, shade, 4.5F * scale);
    list.AddLine(*foot, *tip, style::accent, 2.5F * scale);
    list.AddCircleFilled(*tip, 6.5F * scale, shade);
    list.AddCircleFilled(*tip, 5.0F * scale, style::accent);
    const float reach = grip * scale;
    ImGui::SetCursorScreenPos({tip->x - reach, tip->y - reach});
    ImGui::InvisibleButton(fmt::format("section {}", k).c_str(), {2.0F * reach, 2.0F * reach});
    if (k == state.panes.active()) widgets.note("section.handle");
    if (!ImGui::IsItemActive()) return tooltip(tr("Drag the section plane"));
    if (ImGui::IsItemActivated()) state.panes.activate(k, state.present());
    if (k != state.panes.active() || !state.camera.left_out.cut) return;
    if (!ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0.0F)) return;
    // The tip was taken, not the foot: the ray is led through the foot.
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const Ray ray = pane.ray({mouse.x - (tip->x - foot->x), mouse.y - (tip->y - foot->y)});
    state.camera.left_out.cut = moved_to(cut, ray, bounds, input.snap.raster_now());
}

}  // namespace hanei
