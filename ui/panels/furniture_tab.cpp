#include "engine/edit/furniture_edits.h"
#include "ui/panels/elided.h"
#include "ui/panels/furnishing.h"
#include "ui/panels/furniture_preview.h"
#include "ui/panels/language.h"
#include "ui/panels/place_tool.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui_stdlib.h>

namespace hanei {
namespace {

constexpr float tile = 84.0F;       // pixels at scale 1
constexpr float far_enough = 6.0F;  // pixels the pointer goes before a press is a drag

std::string lower(std::string_view text) {
    std::string small(text);
    std::transform(small.begin(), small.end(), small.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return small;
}

bool is_found(const FurnitureKind& kind, const std::string& search) {
    const std::string wanted = lower(search);
    return wanted.empty() || lower(kind.label).find(wanted) != std::string::npos ||
           lower(tr(kind.label)).find(wanted) != std::string::npos ||
           lower(kind.group).find(wanted) != std::string::npos;
}

std::string sizes_text(const FurnitureKind& kind) {
    const Bounds bounds = [&] {
        Furniture piece;
        for (ModelPart& made : parts_of({std::string(kind.kind), {}})) piece.parts.push_back(std::move(made.part));
        return own_bounds(piece);
    }();
    const Vec3 size = bounds.high - bounds.low;
    return fmt::format("{:.2f} x {:.2f} x {:.2f} m", size.x, size.y, size.z);
}

enum class Touch { none, clicked, carried };

/// A picture with its name below; wrapped words are cut at two lines.
Touch draw_tile(const FurnitureKind& kind, float width, WidgetRegistry& widgets) {
    const float scale = style::scale();
    const float line = ImGui::GetTextLineHeight();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 size{width, width * 0.78F + 2.0F * line + 4.0F * scale};
    const std::string id(kind.kind);
    const bool clicked = ImGui::InvisibleButton(id.c_str(), size);
    widgets.note("library." + id);
    const ImVec2 high{low.x + size.x, low.y + size.y};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
        list.AddRectFilled(low, high, style::chosen, 5.0F * scale);
    } else {
        list.AddRectFilled(low, high, style::field, 5.0F * scale);
    }
    const float margin = 8.0F * scale;
    draw_furniture(kind, {low.x + margin, low.y + margin}, {high.x - margin, low.y + width * 0.78F - 2.0F * scale});
    const std::string label(tr(kind.label));
    const ImVec2 text = ImGui::CalcTextSize(label.c_str(), nullptr, false, width - 6.0F * scale);
    list.PushClipRect(low, high, true);
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(),
                 {low.x + std::max(3.0F * scale, 0.5F * (width - text.x)),
                  low.y + width * 0.78F + std::max(0.0F, line - 0.5F * text.y)},
                 style::text, label.c_str(), nullptr, width - 6.0F * scale);
    list.PopClipRect();
    if (ImGui::IsItemHovered()) tooltip(fmt::format("{}\n{}", tr(kind.help), sizes_text(kind)));
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, far_enough * scale))
        return Touch::carried;
    return clicked ? Touch::clicked : Touch::none;
}

}  // namespace

Furnishing::Wish Furnishing::library(const Scene& scene, ObjectId chosen, WidgetRegistry& widgets) {
    Wish wish;
    const float scale = style::scale();
    ImGui::SetNextItemWidth(-FLT_MIN);
    ImGui::InputTextWithHint("##search", tr("Search"), &search_);
    widgets.note("library.search");
    ImGui::TextColored(style::colour(style::quiet_text), "%s", tr("Click to add, or drag to its place"));
    ImGui::BeginChild("pieces");
    const float space = ImGui::GetContentRegionAvail().x, gap = 6.0F * scale;
    const int columns = std::max(1, static_cast<int>((space + gap) / (tile * scale + gap)));
    const float width = std::floor((space - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns));
    // Groups stand where their first kind does; kinds of one group may lie apart in the library.
    std::vector<std::string_view> groups;
    for (const FurnitureKind& kind : furniture_library())
        if (std::find(groups.begin(), groups.end(), kind.group) == groups.end()) groups.push_back(kind.group);
    bool any = false;
    for (const std::string_view group : groups) {
        int column = 0;
        for (const FurnitureKind& kind : furniture_library()) {
            if (kind.group != group || !is_found(kind, search_)) continue;
            if (column == 0) {
                ImGui::Dummy({0.0F, 2.0F * scale});
                ImGui::TextColored(style::colour(style::quiet_text), "%s", std::string(tr(group)).c_str());
            }
            if (column % columns != 0) ImGui::SameLine(0.0F, gap);
            ++column;
            any = true;
            const Touch touch = draw_tile(kind, width, widgets);
            const FurnitureModel model{std::string(kind.kind), {}};
            if (touch == Touch::carried) wish.tool = std::make_unique<PlaceTool>(model, true);
            if (touch != Touch::clicked) continue;
            Added added = with_furniture(scene, model, chosen);
            wish.chosen = {added.object};
            wish.scene = std::move(added.scene);
            wish.step = "Add " + std::string(kind.label);
        }
    }
    if (!any) quiet_words(tr("Nothing is called so"));
    ImGui::EndChild();
    return wish;
}

}  // namespace hanei
