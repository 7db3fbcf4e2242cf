#include "ui/panels/command.h"

#include "engine/base/check.h"

#include <algorithm>
#include <vector>

namespace hanei {
namespace {

std::vector<Command> all_menus() {
    std::vector<Command> all;
    for (const auto menu : {file_menu(), edit_menu(), add_menu(), room_menu(), arrange_menu(), light_menu(),
                            view_menu(), look_menu(), results_menu(), help_menu()})
        all.insert(all.end(), menu.begin(), menu.end());
    return all;
}

}  // namespace

std::span<const Command> commands() {
    static const std::vector<Command> table = all_menus();
    return table;
}

const Command& command(CommandId id) {
    const std::span<const Command> table = commands();
    const auto found = std::find_if(table.begin(), table.end(), [&](const Command& entry) { return entry.id == id; });
    HANEI_CHECK(found != table.end());
    return *found;
}

const Command* command_for(const Chord& chord) {
    if (chord.key == Key::none) return nullptr;
    for (const Command& entry : commands()) {
        if (entry.chord == chord || entry.other == chord) return &entry;
    }
    return nullptr;
}

}  // namespace hanei
