#include "engine/edit/edit.h"
#include "engine/edit/luminaire_edits.h"
#include "ui/panels/checks.h"
#include "ui/panels/workbench.h"

#include <array>

namespace hanei {
namespace {

using enum CommandId;

constexpr std::array table{
    Command{command_search,
            "help.search",
            "Help",
            "Find a command...",
            "Type what it is called, Enter carries it out",
            {Key::f3},
            control('P', true)},
    Command{show_keys, "help.keys", "Help", "Keys and mouse", "This list", {Key::f1}, {Key::slash, false, true}},
    Command{show_validation,
            "help.validation",
            "Help",
            "Validation...",
            "Compute the reference cases that come with the program: what is expected, what comes out, a signed table",
            {}},
    Command{show_about, "help.about", "Help", "About Hanei", "What this program is, and its licence", {}},
};

}  // namespace

std::span<const Command> help_menu() { return table; }

bool Workbench::can_help(CommandId id) const { return id != CommandId::show_validation || door_.validate; }

void Workbench::do_help(CommandId id) {
    switch (id) {
        case CommandId::command_search:
            return search_.open();
        case CommandId::show_keys:
            return dialogs_.show_keys();
        case CommandId::show_validation:
            return checks_->validation.open(door_.validate);
        case CommandId::show_about:
            return dialogs_.show_about();
        default:
            return;
    }
}

}  // namespace hanei
