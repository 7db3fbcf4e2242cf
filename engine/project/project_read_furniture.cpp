#include "engine/edit/furniture_edits.h"
#include "engine/project/project_reader.h"

#include <fmt/format.h>

namespace hanei {
namespace {

void take_shape(Fields& fields, Part& part) {
    const bool box = fields.has("box");
    if (box == fields.has("vertices")) {
        fields.error("box", box ? "a part is a \"box\" or has \"vertices\" and \"faces\", not both"
                                : "expected \"box\": [x, y, z], or \"vertices\" and \"faces\" of a closed solid");
        fields.take("box");
        fields.take("vertices");
        fields.take("faces");
    } else if (box) {
        BoxShape shape;
        fields.optional("box", shape.size);
        part.shape = shape;
    } else {
        SolidShape shape;
        fields.optional("vertices", shape.vertices);
        fields.require("faces", shape.faces, "lists of vertex numbers, counter-clockwise seen from outside");
        part.shape = std::move(shape);
    }
}

Part part_of(SceneReader& reader, Fields& fields) {
    Part part;
    take_shape(fields, part);
    fields.optional("position", part.position);
    fields.optional_angle("rotation_deg", part.rotation);
    part.material = take_material(reader, fields, "material");
    part.unknown = fields.unknown();
    return part;
}

/// {"kind": "desk", "sizes": {"width": 1.8}}
FurnitureModel model_of(SceneReader& reader, Fields& fields, JsonValue& kept) {
    FurnitureModel model;
    const JsonValue* const value = fields.take("model");
    if (value == nullptr) return model;
    Fields stated(reader.reading, *value, fields.path_of("model"));
    stated.require("kind", model.kind, "the name of a kind of the furniture library, as \"desk\"");
    if (stated.has("kind") && model.kind.empty()) stated.error("kind", "a model must have a kind; leave it out if not");
    const FurnitureKind* const kind = find_furniture_kind(model.kind);
    if (const JsonValue* const list = stated.take("sizes")) {
        Fields sizes(reader.reading, *list, stated.path_of("sizes"));
        for (const std::string& name : list->keys) {
            double size = 0.0;
            if (!sizes.optional(name, size)) continue;
            model.sizes.push_back({name, size});
            const FurnitureSize* const known = kind == nullptr ? nullptr : find_size(*kind, name);
            if (known != nullptr && !(size >= known->low && size <= known->high))
                sizes.error(name, fmt::format("found {:g}, allowed is {:g} to {:g}", size, known->low, known->high));
            if (kind != nullptr && known == nullptr)
                sizes.error(name, fmt::format("a {} has no such size", model.kind));
        }
    }
    keep_unknown(stated, "model", kept);
    return model;
}

}  // namespace

void read_furniture(SceneReader& reader, Fields& root) {
    for_each_object(root, "furniture", [&](Fields& fields, std::size_t) {
        Furniture furniture;
        furniture.id = reader.take_id(fields);
        fields.optional("name", furniture.name);
        fields.require("position", furniture.position, "three numbers [x, y, z]");
        fields.optional_angle("rotation_deg", furniture.rotation);
        JsonValue kept = json_object();
        furniture.model = model_of(reader, fields, kept);
        const bool follows = !fields.has("parts") && find_furniture_kind(furniture.model.kind) != nullptr;
        if (follows) furniture.parts = made_furniture(reader.scene, furniture.model).parts;
        for_each_object(fields, "parts",
                        [&](Fields& part, std::size_t) { furniture.parts.push_back(part_of(reader, part)); });
        furniture.unknown = unknown_of(fields, std::move(kept));
        reader.scene.furniture.push_back(std::move(furniture));
    });
}

void read_surfaces(SceneReader& reader, Fields& root) {
    for_each_object(root, "surfaces", [&](Fields& fields, std::size_t) {
        FreeSurface surface;
        surface.id = reader.take_id(fields);
        fields.optional("name", surface.name);
        fields.require("outline", surface.region.outline, "points [x, y, z], counter-clockwise seen from the front");
        fields.optional("holes", surface.region.holes);
        surface.material = take_material(reader, fields, "material");
        fields.optional("exitance_lm_m2", surface.own_exitance.value);
        surface.unknown = fields.unknown();
        reader.scene.surfaces.push_back(std::move(surface));
    });
}

void read_calculation(SceneReader& reader, Fields& root) {
    for_each_object(root, "grids", [&](Fields& fields, std::size_t) {
        CalculationGrid grid;
        grid.id = reader.take_id(fields);
        fields.optional("name", grid.name);
        fields.require("corner", grid.corner, "three numbers [x, y, z]");
        fields.require("along", grid.along, "the first side as a vector [x, y, z]");
        fields.require("across", grid.across, "the second side as a vector [x, y, z]");
        fields.optional("spacing", grid.spacing);
        grid.unknown = fields.unknown();
        reader.scene.grids.push_back(std::move(grid));
    });
    for_each_object(root, "points", [&](Fields& fields, std::size_t) {
        CalculationPoint point;
        point.id = reader.take_id(fields);
        fields.optional("name", point.name);
        fields.require("position", point.position, "three numbers [x, y, z]");
        fields.optional("normal", point.normal);
        point.unknown = fields.unknown();
        reader.scene.points.push_back(std::move(point));
    });
}

namespace {

std::optional<Cut> read_cut(Fields& root, JsonValue& kept) {
    const JsonValue* const value = root.take("cut");
    if (value == nullptr) return std::nullopt;
    Fields fields(root.reading(), *value, root.path_of("cut"));
    Cut cut;
    fields.require("normal", cut.normal, "three numbers [x, y, z], towards what is left out");
    fields.require("offset", cut.offset, "a number in metres along the normal");
    keep_unknown(fields, "cut", kept);
    return cut;
}

}  // namespace

void read_views(SceneReader& reader, Fields& root) {
    for_each_object(root, "views", [&](Fields& fields, std::size_t) {
        View view;
        view.id = reader.take_id(fields);
        fields.optional("name", view.name);
        fields.require("eye", view.eye, "three numbers [x, y, z]");
        fields.require("target", view.target, "three numbers [x, y, z]");
        fields.optional_angle("field_of_view_deg", view.field_of_view);
        fields.optional("orthographic", view.orthographic);
        fields.optional("hides_ceiling", view.hides_ceiling);
        JsonValue kept = json_object();
        view.cut = read_cut(fields, kept);
        view.unknown = unknown_of(fields, std::move(kept));
        reader.scene.views.push_back(std::move(view));
    });
}

}  // namespace hanei
