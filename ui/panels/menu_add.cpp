#include "engine/edit/edit.h"
#include "engine/edit/luminaire_edits.h"
#include "ui/panels/hanging.h"
#include "ui/panels/workbench.h"

#include <array>

namespace hanei {
namespace {

using enum CommandId;

constexpr std::array table{
    Command{add_panel_luminaire, "add.panel", "Add", "Panel luminaire", "A diffuse 0.6 m x 0.6 m ceiling panel", {}},
    Command{add_line_luminaire, "add.line", "Add", "Line luminaire", "A diffuse tube, 1.2 m long", {}},
    Command{add_point_luminaire, "add.point", "Add", "Point luminaire", "A small lamp shining evenly all around", {}},
    Command{add_luminaire_file, "add.file", "Add", "Luminaire from file...",
            "A luminaire as a file measures it: IES, EULUMDAT, TM-33, GLDF, glTF. Or drop the file on the room",
            control('L')},
    Command{add_box, "add.box", "Add", "Furniture box", "A box to stand on the floor", control('B'), {}, true},
    Command{add_furniture,
            "add.furniture",
            "Add",
            "Furniture...",
            "Desks, chairs, shelves ... from the library",
            {key_of('A'), false, true}},
    Command{add_grid, "add.grid", "Add", "Calculation grid", "A grid at desk height over the room", {}, {}, true},
    Command{add_calculation_point,
            "add.calculation_point",
            "Add",
            "Calculation point",
            "A single point at desk height, facing up",
            {}},
};

}  // namespace

std::span<const Command> add_menu() { return table; }

bool Workbench::can_add(CommandId) const { return true; }

void Workbench::do_add(CommandId id) {
    const Scene& scene = *document_.shown();
    switch (id) {
        case CommandId::add_point_luminaire:
            return add(with_point_luminaire(scene), "Add point luminaire");
        case CommandId::add_line_luminaire:
            return add(with_line_luminaire(scene), "Add line luminaire");
        case CommandId::add_panel_luminaire:
            return add(with_panel_luminaire(scene), "Add panel luminaire");
        case CommandId::add_luminaire_file: {
            Arrival arrival;
            arrival.place = place_in_plan(scene, {}, raster());
            return add_luminaire_file(std::move(arrival));
        }
        case CommandId::add_box:
            return add(with_box(scene), "Add box");
        case CommandId::add_furniture:
            return furnishing_.show_library();
        case CommandId::add_grid:
            return add(with_grid(scene), "Add calculation grid");
        case CommandId::add_calculation_point:
            return add(with_calculation_point(scene), "Add calculation point");
        default:
            return;
    }
}

}  // namespace hanei
