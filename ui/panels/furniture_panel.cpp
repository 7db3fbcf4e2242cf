#include "engine/edit/furniture_edits.h"
#include "ui/panels/edited_object.h"
#include "ui/panels/properties.h"
#include "ui/panels/property_rows.h"

#include <fmt/format.h>

namespace hanei {
namespace {

/// Parts by themselves. A changed shape takes the model away; a changed material does not.
bool part_rows(const Scene& scene, Furniture& furniture, Form& form) {
    bool changed = false;
    for (std::size_t k = 0; k < furniture.parts.size(); ++k) {
        Part& part = furniture.parts[k];
        const std::string owner = fmt::format("part{}", k + 1);
        form.heading(furniture.parts.size() == 1 ? "Body" : fmt::format("Part {}", k + 1).c_str());
        if (auto* box = std::get_if<BoxShape>(&part.shape)) {
            const auto side = [&](const char* axis, const char* label, double& length) {
                const std::string name = owner + "." + axis;
                changed |= form.number({name.c_str(), label, "m", "Size of the box", 0.001, 1000.0, 0.01, 3}, length);
            };
            side("width", "Width", box->size.x);
            side("depth", "Depth", box->size.y);
            side("height", "Height", box->size.z);
        } else {
            form.fact("Shape", "Solid");
        }
        const std::string material = owner + ".material";
        changed |= material_row(material.c_str(), "Material", scene, part.material, form);
    }
    return changed;
}

bool model_rows(const Scene& scene, const FurnitureKind& kind, Furniture& furniture, Form& form) {
    bool changed = false;
    form.heading("Sizes");
    for (const FurnitureSize& size : kind.sizes) {
        const std::string name = fmt::format("model.{}", size.name);
        const std::string label(size.label), help(size.help);
        const bool is_length = !size.counts && size.high > 1.0;
        double value = size_of(kind, furniture.model, size.name);
        if (!form.number({name.c_str(), label.c_str(), is_length ? "m" : "", help.c_str(), size.low, size.high,
                          size.counts ? 0.05 : 0.005, size.counts ? 0 : 3},
                         value))
            continue;
        set_model_size(furniture, size.name, value);
        changed = true;
    }
    form.heading("Materials");
    for (std::size_t k = 0; k < kind.finishes.size(); ++k) {
        const std::string name = fmt::format("finish{}.material", k + 1);
        const std::string label(kind.finishes[k].label);
        ObjectId material = material_of_finish(furniture, static_cast<int>(k));
        if (!material_row(name.c_str(), label.c_str(), scene, material, form)) continue;
        set_finish(furniture, static_cast<int>(k), material);
        changed = true;
    }
    if (form.button("model.dissolve", "Edit parts by themselves",
                    "Leaves the library: its sizes are given up, each part can be changed")) {
        furniture.model = {};
        changed = true;
    }
    return changed;
}

}  // namespace

std::optional<Scene> furniture_panel(const Scene& scene, ObjectId id, Form& form) {
    return edited(scene, &Scene::furniture, id, [&](Furniture& furniture) {
        bool changed = form.text("furniture.name", "Name", "What this piece is called", furniture.name);
        const FurnitureKind* const kind = find_furniture_kind(furniture.model.kind);
        if (kind != nullptr) form.fact("Model", std::string(kind->label));
        form.heading("Place");
        changed |= place_rows("furniture", furniture.position, form);
        changed |= angle_row({"furniture.rotation", "Turn", "°", "About the vertical, counter-clockwise from above",
                              -360.0, 360.0, 0.5, 1},
                             furniture.rotation, form);
        return (kind != nullptr ? model_rows(scene, *kind, furniture, form) : part_rows(scene, furniture, form)) ||
               changed;
    });
}

}  // namespace hanei
