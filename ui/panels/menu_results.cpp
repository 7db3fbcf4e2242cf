#include "engine/edit/edit.h"
#include "ui/panels/checks.h"
#include "ui/panels/workbench.h"

#include <array>
#include <fmt/format.h>

namespace hanei {
namespace {

using enum CommandId;

constexpr std::array table{
    Command{toggle_values, "results.values", "Results", "Figures in the view",
            "Write the illuminance at the points of calculation grids into the view", plain('V')},
    Command{pin_here, "results.pin", "Results", "Pin here",
            "A calculation point on the surface under the pointer, facing as the surface does", plain('X')},
    Command{explain, "results.why", "Results", "Why is it bright here",
            "Divide the light under the pointer, or at the chosen point, by where it comes from", plain('Y')},
    Command{keep_a,
            "results.keep_a",
            "Results",
            "Keep as A",
            "Keep the light as it is now, to be compared as A",
            {key_of('A'), false, false, true},
            {},
            true},
    Command{keep_b,
            "results.keep_b",
            "Results",
            "Keep as B",
            "Keep the light as it is now, to be compared as B",
            {key_of('B'), false, false, true}},
    Command{show_a,
            "results.show_a",
            "Results",
            "Show A",
            "Show A in place of the room as it is; holding the key ` shows it for as long as it is held",
            {}},
    Command{show_difference, "results.difference", "Results", "Show B − A",
            "How much more or less light there is in B, or now, than in A", plain('J')},
    Command{draw_profile,
            "results.profile",
            "Results",
            "Profile along a line",
            "Draw a line on a surface: the light along it as curves",
            plain('L'),
            {},
            true},
    Command{show_histogram,
            "results.histogram",
            "Results",
            "Histogram",
            "How much of the chosen grid, or of all surfaces, has how much light",
            {}},
    Command{compare_measured,
            "results.measured",
            "Results",
            "Compare with measured values...",
            "Set a table of a meter or another program (CSV) beside the values of the room as it is",
            {}},
    Command{study_accuracy,
            "results.study",
            "Results",
            "Accuracy against time",
            "How exact each method is on this room and how long it takes; a click on a point uses it",
            {}},
    Command{check_scene,
            "results.check",
            "Results",
            "Check the scene",
            "List what is wrong with the scene and what is hard in it; a click on a message selects the object",
            {}},
    Command{check_answer,
            "results.trust",
            "Results",
            "Check this answer...",
            "What must hold of any right answer: energy, reciprocity, closure, additivity, the same on any threads",
            {}},
};

}  // namespace

std::span<const Command> results_menu() { return table; }

bool Workbench::can_results(CommandId id) const {
    const bool point = kind_of(*document_.shown(), selection_.primary()) == ObjectKind::point;
    switch (id) {
        case CommandId::pin_here:
            return viewport_.probe().has_value() && !viewport_.probe()->value.inside_solid;
        case CommandId::explain:
            return viewport_.probe().has_value() || point;
        case CommandId::keep_a:
        case CommandId::keep_b:
        case CommandId::check_answer:
            return study_.answer() != nullptr;
        case CommandId::compare_measured:
            return study_.answer() != nullptr && door_.read_measured;
        case CommandId::show_a:
        case CommandId::show_difference:
            return readings_.snapshots.a().has_value();
        default:
            return true;
    }
}

void Workbench::do_results(CommandId id) {
    const std::optional<Probe>& probe = viewport_.probe();
    switch (id) {
        case CommandId::toggle_values:
            viewport_.state.options.values = !viewport_.state.options.values;
            return;
        case CommandId::pin_here: {
            Scene wished = *document_.shown();
            CalculationPoint pin;
            pin.id = wished.new_id();
            int number = 1;
            while (object_named(wished, fmt::format("Pin {}", number))) ++number;
            pin.name = fmt::format("Pin {}", number);
            pin.position = probe->position;
            pin.normal = probe->normal;
            const ObjectId id_of_pin = pin.id;
            wished.points.push_back(std::move(pin));
            add({std::move(wished), id_of_pin}, "Pin here");
            return;
        }
        case CommandId::explain:
            if (probe) {
                readings_.why.ask(probe->position, probe->normal, probe->surface);
                if (kind_of(*document_.shown(), selection_.primary()) == ObjectKind::point) selection_.clear();
            }
            readings_.front_tab = "Why";
            return;
        case CommandId::keep_a:
        case CommandId::keep_b:
            return keep_state(id == CommandId::keep_a);
        case CommandId::show_a:
            readings_.snapshots.show =
                readings_.snapshots.show == Snapshots::Show::a ? Snapshots::Show::now : Snapshots::Show::a;
            return;
        case CommandId::show_difference:
            readings_.snapshots.show = readings_.snapshots.show == Snapshots::Show::difference
                                           ? Snapshots::Show::now
                                           : Snapshots::Show::difference;
            readings_.front_tab = "Compare";
            return;
        case CommandId::draw_profile:
            readings_.front_tab = "Profile";
            return viewport_.take_up(std::make_unique<ProfileTool>(readings_.profile));
        case CommandId::compare_measured:
            return compare_measured();
        case CommandId::check_scene:
            messages_panel_.list_hard_spots();
            opens_messages_ = true;
            return;
        case CommandId::show_histogram:
            readings_.front_tab = "Histogram";
            return;
        case CommandId::study_accuracy:
            readings_.front_tab = "Study";
            return;
        case CommandId::check_answer:
            return checks_->trust.open(study_.answer()->scene, study_.answer()->settings);
        default:
            return;
    }
}

/// A double click beside all objects pins the place, as X does.
void Workbench::pin_at_double_click() {
    if (!ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) || viewport_.tool() != nullptr) return;
    if (!viewport_.probe() || !can(CommandId::pin_here)) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (viewport_.pointed(*document_.shown(), mouse).object) return;
    do_results(CommandId::pin_here);
}

}  // namespace hanei
