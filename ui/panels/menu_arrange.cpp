#include "engine/edit/aligning.h"
#include "engine/edit/hanging.h"
#include "engine/edit/plan_shape.h"
#include "engine/edit/standing.h"
#include "ui/panels/workbench.h"

#include <array>

namespace hanei {
namespace {

using enum CommandId;

constexpr std::array table{
    Command{array_copies,
            "arrange.array",
            "Arrange",
            "Array...",
            "Copies of the selection in rows and columns",
            {key_of('D'), true, true}},
    Command{
        circle_copies, "arrange.circle", "Arrange", "Circular array...", "Copies of the selection around a middle", {}},
    Command{mirror_left_right,
            "arrange.mirror_x",
            "Arrange",
            "Mirror left and right",
            "The selection's mirror image about its own middle",
            {key_of('M'), true},
            {},
            true},
    Command{mirror_up_down,
            "arrange.mirror_y",
            "Arrange",
            "Mirror front and back",
            "The selection's mirror image about its own middle, front to back in the plan",
            {key_of('M'), true, true}},
    Command{mirror_over_x,
            "arrange.mirror_copy_x",
            "Arrange",
            "Mirrored copy, left to right",
            "A mirror image on the other side of the room's middle line",
            {}},
    Command{mirror_over_y,
            "arrange.mirror_copy_y",
            "Arrange",
            "Mirrored copy, front to back",
            "A mirror image on the other side of the room's middle line",
            {}},
    Command{align_left,
            "arrange.left",
            "Arrange",
            "Align left",
            "Left sides in line with the one chosen last",
            {},
            {},
            true},
    Command{align_middle_x,
            "arrange.middle_x",
            "Arrange",
            "Align middles, left to right",
            "Middles one behind the other, as the one chosen last",
            {}},
    Command{align_right, "arrange.right", "Arrange", "Align right", "Right sides in line with the one chosen last", {}},
    Command{align_top,
            "arrange.top",
            "Arrange",
            "Align back",
            "Upper sides in the plan in line with the one chosen last",
            {}},
    Command{align_middle_y,
            "arrange.middle_y",
            "Arrange",
            "Align middles, front to back",
            "Middles side by side, as the one chosen last",
            {}},
    Command{align_bottom,
            "arrange.bottom",
            "Arrange",
            "Align front",
            "Lower sides in the plan in line with the one chosen last",
            {}},
    Command{spread_x,
            "arrange.spread_x",
            "Arrange",
            "Equal gaps, left to right",
            "The same space between neighbours; the outermost stay",
            {},
            {},
            true},
    Command{spread_y,
            "arrange.spread_y",
            "Arrange",
            "Equal gaps, front to back",
            "The same space between neighbours; the outermost stay",
            {}},
    Command{put_on_floor,
            "arrange.floor",
            "Arrange",
            "Put on the floor",
            "Lower or raise the selection to the floor",
            {Key::end},
            {},
            true},
    Command{push_to_wall,
            "arrange.wall",
            "Arrange",
            "Push against the wall",
            "Turn furniture's back to the nearest wall and move it there",
            {}},
    Command{turn_to_wall,
            "arrange.turn_to_wall",
            "Arrange",
            "Turn to the wall",
            "Turn furniture's back to the nearest wall",
            {}},
    Command{group_objects,
            "arrange.group",
            "Arrange",
            "Group",
            "Choose and move the selection as one from now on",
            control('G'),
            {},
            true},
    Command{ungroup_objects, "arrange.ungroup", "Arrange", "Ungroup", "Take the group apart", control('G', true)},
};

std::optional<Alignment> alignment_of(CommandId id) {
    switch (id) {
        case align_left:
            return Alignment::left;
        case align_middle_x:
            return Alignment::middle_x;
        case align_right:
            return Alignment::right;
        case align_top:
            return Alignment::top;
        case align_middle_y:
            return Alignment::middle_y;
        case align_bottom:
            return Alignment::bottom;
        default:
            return std::nullopt;
    }
}

bool has_furniture(const Scene& scene, const ObjectIds& chosen) {
    const ObjectIds objects = objects_of(scene, chosen);
    return std::any_of(objects.begin(), objects.end(),
                       [&](ObjectId id) { return kind_of(scene, id) == ObjectKind::furniture; });
}

/// Each piece of furniture among them by itself.
template <class Edit>
Scene each_piece(Scene scene, const ObjectIds& chosen, const Edit& edit) {
    for (const ObjectId id : objects_of(scene, chosen))
        if (std::optional<Scene> wished = edit(scene, id)) scene = std::move(*wished);
    return scene;
}

}  // namespace

std::span<const Command> arrange_menu() { return table; }

bool Workbench::can_arrange(CommandId id) const {
    const Scene& scene = *document_.shown();
    const ObjectIds& chosen = selection_.ids();
    const bool placed = bounds_of_objects(scene, chosen).has_value();
    switch (id) {
        case group_objects:
            return can_group(scene, chosen);
        case ungroup_objects:
            return can_ungroup(scene, chosen);
        case put_on_floor:
        case push_to_wall:
        case turn_to_wall:
            return has_furniture(scene, chosen) && (id == put_on_floor || scene.room);
        case spread_x:
        case spread_y:
            return placed && chosen.size() > 2;
        case mirror_over_x:
        case mirror_over_y:
            return placed && scene.room;
        default:
            return placed && (!alignment_of(id) || chosen.size() > 1);
    }
}

void Workbench::do_arrange(CommandId id) {
    const Scene& scene = *document_.shown();
    const ObjectIds chosen = selection_.ids();
    if (const auto alignment = alignment_of(id))
        return document_.commit(aligned(scene, chosen, *alignment), std::string(command(id).label));
    const Bounds bounds = bounds_of_objects(scene, chosen).value_or(Bounds{});
    const Vec3 middle = 0.5 * (bounds.low + bounds.high);
    const Vec2 room = bounds_of_plan(scene).middle();
    const std::string words = words_for(scene, chosen);
    switch (id) {
        case array_copies:
            return furnishing_.ask_array();
        case circle_copies:
            return furnishing_.ask_circle(room);
        case mirror_left_right:
            return document_.commit(mirrored(scene, chosen, MirrorAxis::x, middle.x), "Mirror " + words);
        case mirror_up_down:
            return document_.commit(mirrored(scene, chosen, MirrorAxis::y, middle.y), "Mirror " + words);
        case mirror_over_x:
            return add(with_mirror_image(scene, chosen, MirrorAxis::x, room.x), "Mirrored copy");
        case mirror_over_y:
            return add(with_mirror_image(scene, chosen, MirrorAxis::y, room.y), "Mirrored copy");
        case spread_x:
            return document_.commit(distributed(scene, chosen, Spread::x), "Equal gaps");
        case spread_y:
            return document_.commit(distributed(scene, chosen, Spread::y), "Equal gaps");
        case put_on_floor:
            return document_.commit(on_floor(scene, chosen), "Put on the floor");
        case push_to_wall:
            return document_.commit(
                each_piece(scene, chosen,
                           [](const Scene& before, ObjectId piece) { return against_wall(before, piece, HUGE_VAL); }),
                "Push against the wall");
        case turn_to_wall:
            return document_.commit(each_piece(scene, chosen, turned_to_wall), "Turn to the wall");
        case group_objects:
            return add(grouped(scene, chosen), "Group");
        case ungroup_objects: {
            Ungrouped apart = ungrouped(scene, chosen);
            document_.commit(std::move(apart.scene), "Ungroup");
            return choose(apart.members);
        }
        default:
            return;
    }
}

}  // namespace hanei
