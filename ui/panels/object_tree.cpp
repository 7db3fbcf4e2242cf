#include "ui/panels/object_tree.h"

#include "ui/panels/choosing.h"
#include "ui/panels/elided.h"
#include "ui/panels/form.h"
#include "ui/panels/icon.h"
#include "ui/panels/language.h"
#include "ui/panels/property_rows.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

class Rows {
public:
    Rows(const Scene& scene, const Selection& selection, ObjectId roll_to, WidgetRegistry& widgets)
        : scene_(scene),
          selection_(selection),
          within_(objects_of(scene, selection.ids())),
          roll_to_(roll_to),
          widgets_(widgets) {}

    template <class List>
    void branch(const char* title, const List& list, ImU32 mark) {
        const bool wanted =
            std::any_of(list.begin(), list.end(), [&](const auto& object) { return object.id == roll_to_; });
        if (list.empty() || !heading(title, list.size(), wanted)) return;
        for (const auto& object : list) leaf(object.id, mark_in_list(object, mark));
        ImGui::TreePop();
    }

    void room() {
        if (scene_.room) leaf(scene_.room->id, style::quiet_text);
    }

    ObjectIds order;  ///< of the rows that were drawn
    ObjectId clicked;
    bool by_right_button = false;

private:
    bool heading(const char* title, std::size_t count, bool wanted) {
        if (wanted) ImGui::SetNextItemOpen(true);
        ImGui::PushStyleColor(ImGuiCol_Text, style::quiet_text);
        const std::string text = fmt::format("{}  {}###{}", tr(title), count, title);
        const bool is_open =
            ImGui::TreeNodeEx(text.c_str(), ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_DefaultOpen);
        widgets_.note(fmt::format("tree.{}", title));
        ImGui::PopStyleColor();
        return is_open;
    }

    void leaf(ObjectId id, ImU32 mark) {
        const std::string name = display_name(scene_, id);
        const float height = ImGui::GetTextLineHeight();
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const bool chosen = selection_.holds(id);
        const bool taken_along = !chosen && std::find(within_.begin(), within_.end(), id) != within_.end();
        ImGui::PushID(static_cast<int>(id.value));
        if (taken_along) ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
        const float indent = ImGui::CalcTextSize("      ").x;
        const std::string shown = elided(name, ImGui::GetContentRegionAvail().x - indent, Elide::middle);
        if (ImGui::Selectable(("      " + shown + "###row").c_str(), chosen || taken_along)) clicked = id;
        if (taken_along) ImGui::PopStyleColor();
        widgets_.note("tree." + name);
        if (shown.size() != name.size()) tooltip(name);
        if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
            clicked = id;
            by_right_button = true;
        }
        if (id == roll_to_ && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
        ImGui::PopID();
        draw_mark({at.x + 3.0F * style::scale(), at.y}, height, id, mark);
        order.push_back(id);
    }

    /// A drawing of its kind; a material's own colour.
    void draw_mark(ImVec2 at, float height, ObjectId id, ImU32 mark) const {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const float size = std::round(0.85F * icon_size());
        const ImVec2 low{at.x, std::round(at.y + 0.5F * (height - size))}, high{low.x + size, low.y + size};
        const ObjectKind kind = kind_of(scene_, id);
        if (kind == ObjectKind::material) {
            list.AddRectFilled(low, high, mark, 3.0F * style::scale());
            list.AddRect(low, high, style::border, 3.0F * style::scale(), ImDrawFlags_None, style::hairline());
            return;
        }
        constexpr double seen = 2.0;  // of contrast: pale light on a pale panel is drawn in the accent
        const ImU32 ink = style::contrast(mark, style::panel) < seen ? ImU32(style::accent) : mark;
        draw_icon(list, icon_of(kind), low, size, ink);
    }

    /// A material is shown in its own colour, a luminaire in that of its light.
    template <class Object>
    ImU32 mark_in_list(const Object& object, ImU32 mark) const {
        if constexpr (requires { mark_of(object); })
            return mark_of(object);
        else if constexpr (requires { mark_of(object, scene_); })
            return mark_of(object, scene_);
        else
            return mark;
    }

    const Scene& scene_;
    const Selection& selection_;
    ObjectIds within_;  ///< chosen by way of a group
    ObjectId roll_to_;
    WidgetRegistry& widgets_;
};

}  // namespace

ObjectTree::Outcome ObjectTree::draw(const Scene& scene, const Selection& selection, WidgetRegistry& widgets) {
    const bool elsewhere = selection.primary() != shown_;
    shown_ = selection.primary();
    Rows rows(scene, selection, elsewhere ? shown_ : ObjectId{}, widgets);
    rows.room();
    if (scene.room) rows.branch("Doors and windows", scene.room->sub_areas, style::quiet_text);
    rows.branch("Luminaires", scene.luminaires, style::accent);
    rows.branch("Arrangements", scene.arrangements, style::accent);
    rows.branch("Furniture", scene.furniture, style::furniture);
    rows.branch("Surfaces", scene.surfaces, style::furniture);
    rows.branch("Groups", scene.object_groups, style::furniture);
    rows.branch("Grids", scene.grids, style::reading);
    rows.branch("Points", scene.points, style::reading);
    rows.branch("Materials", scene.materials, style::quiet_text);
    rows.branch("Views", scene.views, style::sight);
    if (!rows.clicked) return {};
    Selection after = selection;
    if (rows.by_right_button) {
        if (!after.holds(rows.clicked)) after.choose(rows.clicked);
    } else if (ImGui::GetIO().KeyShift) {
        after.clear();
        for (const ObjectId id : rows_between(rows.order, anchor_, rows.clicked)) after.add(id);
        after.add(rows.clicked);
    } else if (ImGui::GetIO().KeyCtrl) {
        after.toggle(rows.clicked);
    } else {
        after.choose(rows.clicked);
    }
    if (!ImGui::GetIO().KeyShift) anchor_ = rows.clicked;
    shown_ = after.primary();
    return {std::move(after), rows.by_right_button};
}

}  // namespace hanei
