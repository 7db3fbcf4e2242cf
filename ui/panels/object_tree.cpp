#include "ui/panels/object_tree.h"

#include "engine/edit/edit.h"
#include "ui/panels/property_rows.h"
#include "ui/panels/style.h"

#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

class Tree {
public:
    Tree(const Scene& scene, ObjectId selected, WidgetRegistry& widgets)
        : scene_(scene), selected_(selected), widgets_(widgets) {}

    template <class List>
    void branch(const char* title, const List& list, ImU32 mark, bool open) {
        if (list.empty() || !heading(title, list.size(), open)) return;
        for (const auto& object : list) leaf(object.id, mark_in_list(object, mark));
        ImGui::TreePop();
    }

    void room() {
        if (scene_.room) leaf(scene_.room->id, style::quiet_text);
    }

    std::optional<ObjectId> clicked;

private:
    bool heading(const char* title, std::size_t count, bool open) {
        ImGui::PushStyleColor(ImGuiCol_Text, style::quiet_text);
        const std::string text = fmt::format("{}  {}###{}", title, count, title);
        const int flags = ImGuiTreeNodeFlags_SpanAvailWidth | (open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
        const bool is_open = ImGui::TreeNodeEx(text.c_str(), flags);
        widgets_.note(fmt::format("tree.{}", title));
        ImGui::PopStyleColor();
        return is_open;
    }

    void leaf(ObjectId id, ImU32 mark) {
        const std::string name = display_name(scene_, id);
        const float height = ImGui::GetTextLineHeight();
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::PushID(static_cast<int>(id.value));
        if (ImGui::Selectable(("      " + name).c_str(), id == selected_)) clicked = id;
        widgets_.note("tree." + name);
        if (id == selected_ && ImGui::IsWindowAppearing()) ImGui::SetScrollHereY();
        ImGui::PopID();
        const float radius = 4.0F * style::scale();
        ImGui::GetWindowDrawList()->AddCircleFilled({at.x + 2.0F * radius, at.y + 0.5F * height}, radius, mark);
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
    ObjectId selected_;
    WidgetRegistry& widgets_;
};

}  // namespace

std::optional<ObjectId> object_tree(const Scene& scene, ObjectId selected, WidgetRegistry& widgets) {
    Tree tree(scene, selected, widgets);
    tree.room();
    tree.branch("Luminaires", scene.luminaires, style::accent, true);
    tree.branch("Furniture", scene.furniture, style::furniture, true);
    tree.branch("Surfaces", scene.surfaces, style::furniture, true);
    tree.branch("Grids", scene.grids, style::reading, true);
    tree.branch("Points", scene.points, style::reading, true);
    tree.branch("Materials", scene.materials, style::quiet_text, true);
    tree.branch("Views", scene.views, style::sight, true);
    return tree.clicked;
}

}  // namespace hanei
