#include "ui/panels/sketch.h"

#include "ui/panels/style.h"

#include <algorithm>
#include <cmath>

namespace hanei::sketch {

void line(const Pane& pane, const std::vector<Vec3>& places, ImU32 colour, float width) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const std::vector<ImVec2>& run : pane.on_screen(places)) {
        if (run.size() < 2) continue;
        const int count = static_cast<int>(run.size());
        list.AddPolyline(run.data(), count, style::shade, ImDrawFlags_None, (width + 2.0F) * style::scale());
        list.AddPolyline(run.data(), count, colour, ImDrawFlags_None, width * style::scale());
    }
}

void loop(const Pane& pane, std::vector<Vec3> places, ImU32 colour, float width) {
    if (places.empty()) return;
    places.push_back(places.front());
    line(pane, places, colour, width);
}

void fill(const Pane& pane, const std::vector<Vec3>& outline, ImU32 colour) {
    std::vector<ImVec2> shown;
    for (const Vec3& place : outline) {
        const auto at = pane.on_screen(place);
        if (!at) return;
        shown.push_back(*at);
    }
    if (shown.size() > 2)
        ImGui::GetWindowDrawList()->AddConvexPolyFilled(shown.data(), static_cast<int>(shown.size()), colour);
}

void dot(ImVec2 at, float radius, ImU32 colour) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddCircleFilled(at, (radius + 1.5F) * style::scale(), style::shade);
    list.AddCircleFilled(at, radius * style::scale(), colour);
}

void chip(ImVec2 middle, const std::string& text, ImU32 colour) {
    const float scale = style::scale();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 at{std::floor(middle.x - 0.5F * size.x), std::floor(middle.y - 0.5F * size.y)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({at.x - 6.0F * scale, at.y - 2.0F * scale},
                       {at.x + size.x + 6.0F * scale, at.y + size.y + 3.0F * scale}, style::card, 4.0F * scale);
    list.AddText(at, colour, text.c_str());
}

ImU32 faint(ImU32 colour, float share) {
    const auto alpha = static_cast<ImU32>(std::lround(255.0F * share));
    return (colour & ~IM_COL32_A_MASK) | (alpha << IM_COL32_A_SHIFT);
}

}  // namespace hanei::sketch
