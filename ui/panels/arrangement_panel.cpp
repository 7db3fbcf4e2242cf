#include "engine/edit/arrangements.h"
#include "engine/edit/hanging.h"
#include "ui/panels/holding_rows.h"
#include "ui/panels/language.h"
#include "ui/panels/properties.h"
#include "ui/panels/property_rows.h"

#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

bool count_row(const char* name, const char* label, const char* help, int& count, Form& form) {
    double shown = count;
    if (!form.number({name, label, "", help, 1.0, most_in_a_row, 0.05, 0}, shown)) return false;
    const int whole = static_cast<int>(std::lround(shown));
    if (whole == count) return false;
    count = whole;
    return true;
}

/// A side of a field by its length and by the spacing of what it is divided into; about its middle.
struct Side {
    const char *length_name, *length_label, *spacing_name, *spacing_label;
};
bool side_rows(const Side& names, Vec3& side, Vec3& corner, int parts, Form& form) {
    double length = glm::length(side), spacing = length / parts;
    bool changed = form.number({names.length_name, names.length_label, "m",
                                "Side of the field; luminaires keep half a spacing from its ends", 0.01, 1e4, 0.01, 3},
                               length);
    if (form.number({names.spacing_name, names.spacing_label, "m", "Between neighbours; half of it at the walls", 0.005,
                     1e4, 0.01, 3},
                    spacing)) {
        length = spacing * parts;
        changed = true;
    }
    const double before = glm::length(side);
    if (!changed || !(before > 0.0)) return false;
    const Vec3 middle = corner + 0.5 * side;
    side *= length / before;
    corner = middle - 0.5 * side;
    return true;
}

struct LayoutRows {
    const Scene& scene;
    Form& form;

    bool operator()(LineLayout& line) const {
        bool changed = count_row("arrangement.count", "Luminaires", "How many hang along the line", line.count, form);
        form.heading("First");
        changed |= place_rows("arrangement.from", line.from, form);
        form.heading("Last");
        changed |= place_rows("arrangement.to", line.to, form);
        form.fact("Spacing",
                  line.count > 1 ? fmt::format("{:.3f}", glm::length(line.to - line.from) / (line.count - 1)) : "-",
                  "m");
        return changed;
    }
    bool operator()(FieldLayout& field) const {
        bool changed =
            count_row("arrangement.columns", "Columns", "Luminaires along its first side", field.columns, form);
        changed |= count_row("arrangement.rows", "Rows", "Luminaires along its second side", field.rows, form);
        form.heading("Size");
        changed |= side_rows({"arrangement.along", "Length", "arrangement.spacing", "Spacing"}, field.along,
                             field.corner, field.columns, form);
        changed |= side_rows({"arrangement.across", "Width", "arrangement.row_spacing", "Row spacing"}, field.across,
                             field.corner, field.rows, form);
        if (form.button("arrangement.whole_room", "Over the whole room",
                        "Half a spacing from the walls on all sides")) {
            const double z = field.corner.z;
            field = std::get<FieldLayout>(field_over_room(scene, z, field.columns, field.rows));
            changed = true;
        }
        form.heading("First corner");
        changed |= place_rows("arrangement.corner", field.corner, form);
        return changed;
    }
    bool operator()(CircleLayout& circle) const {
        bool changed = count_row("arrangement.count", "Luminaires", "How many hang on the circle", circle.count, form);
        changed |=
            form.number({"arrangement.radius", "Radius", "m", "Of the circle", 0.0, 1e4, 0.01, 3}, circle.radius);
        changed |= angle_row(
            {"arrangement.first_angle", "First at", "°", "Where the first one hangs, from x", -360.0, 360.0, 0.5, 1},
            circle.first_angle, form);
        changed |=
            form.toggle("arrangement.outward", "Face outward", "Each is turned by its angle", circle.face_outward);
        form.heading("Middle");
        changed |= place_rows("arrangement.middle", circle.middle, form);
        return changed;
    }
};

}  // namespace

std::optional<Scene> arrangement_panel(const Scene& scene, ObjectId id, Form& form) {
    const Arrangement* const found = find_arrangement(scene, id);
    if (!found) return std::nullopt;
    std::string name = found->name;
    Layout layout = found->layout;
    double yaw = found->yaw;
    const bool renamed = form.text("arrangement.name", "Name", "What this arrangement is called", name);
    bool changed = std::visit(LayoutRows{scene, form}, layout);
    form.heading("Luminaires");
    changed |= angle_row({"arrangement.yaw", "Turn", "°", "Every luminaire, about the vertical", -360.0, 360.0, 0.5, 1},
                         yaw, form);
    const ObjectId own[] = {id};
    const std::vector<ObjectId> members = luminaires_among(scene, own);
    if (auto held = mounting_rows(scene, members, form)) return with_arrangements_kept(std::move(*held));
    form.fact("In it", std::to_string(members.size()));
    if (const std::size_t outside = places_outside(scene, *found); outside > 0)
        form.remark(say(outside == 1 ? "{} of its places lies outside the plan and stays empty."
                                     : "{} of its places lie outside the plan and stay empty.",
                        outside),
                    false);
    if (form.button("arrangement.dissolve", "Take apart", "Its luminaires stay where they are, each by itself"))
        return dissolved(scene, id);
    if (!changed && !renamed) return std::nullopt;
    Scene wished = changed ? with_layout(scene, id, layout, yaw) : scene;
    for (Arrangement& each : wished.arrangements)
        if (each.id == id) each.name = name;
    return wished;
}

}  // namespace hanei
