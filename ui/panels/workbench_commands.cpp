#include "engine/base/check.h"
#include "engine/edit/several.h"
#include "ui/panels/workbench.h"

#include <algorithm>
#include <array>

namespace hanei {

/// The rows of a menu, and the members that know what they do.
struct Workbench::Menu {
    std::span<const Command> rows;
    bool (Workbench::*can)(CommandId) const;
    void (Workbench::*carry_out)(CommandId);
};

const Workbench::Menu& Workbench::menu_of(CommandId id) {
    static const std::array menus{
        Menu{file_menu(), &Workbench::can_file, &Workbench::do_file},
        Menu{edit_menu(), &Workbench::can_edit, &Workbench::do_edit},
        Menu{add_menu(), &Workbench::can_add, &Workbench::do_add},
        Menu{room_menu(), &Workbench::can_room, &Workbench::do_room},
        Menu{arrange_menu(), &Workbench::can_arrange, &Workbench::do_arrange},
        Menu{light_menu(), &Workbench::can_light, &Workbench::do_light},
        Menu{view_menu(), &Workbench::can_view, &Workbench::do_view},
        Menu{look_menu(), &Workbench::can_look, &Workbench::do_look},
        Menu{results_menu(), &Workbench::can_results, &Workbench::do_results},
        Menu{help_menu(), &Workbench::can_help, &Workbench::do_help},
    };
    const auto found = std::find_if(menus.begin(), menus.end(), [&](const Menu& menu) {
        return std::any_of(menu.rows.begin(), menu.rows.end(), [&](const Command& row) { return row.id == id; });
    });
    HANEI_CHECK(found != menus.end());
    return *found;
}

bool Workbench::can(CommandId id) const { return (this->*menu_of(id).can)(id); }
void Workbench::carry_out(CommandId id) { (this->*menu_of(id).carry_out)(id); }

void Workbench::add(Added added, const char* step) {
    document_.commit(std::move(added.scene), step);
    selection_.choose(added.object);
}

void Workbench::add(AddedSeveral added, std::string step) {
    document_.commit(std::move(added.scene), std::move(step));
    choose(added.objects);
}

void Workbench::choose(const ObjectIds& ids) {
    selection_.clear();
    for (const ObjectId id : ids) selection_.add(id);
}

void Workbench::nudge(const Vec3& direction) {
    const double step = ImGui::GetIO().KeyShift ? 0.01 : 0.1;
    const Scene& scene = *document_.shown();
    document_.commit(moved(scene, selection_.ids(), step * direction), "Move " + words_for(scene, selection_.ids()));
}

}  // namespace hanei
