#include "engine/project/project_reader.h"

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

}  // namespace

void read_furniture(SceneReader& reader, Fields& root) {
    for_each_object(root, "furniture", [&](Fields& fields, std::size_t) {
        Furniture furniture;
        furniture.id = reader.take_id(fields);
        fields.optional("name", furniture.name);
        fields.require("position", furniture.position, "three numbers [x, y, z]");
        fields.optional_angle("rotation_deg", furniture.rotation);
        for_each_object(fields, "parts",
                        [&](Fields& part, std::size_t) { furniture.parts.push_back(part_of(reader, part)); });
        furniture.unknown = fields.unknown();
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

void read_views(SceneReader& reader, Fields& root) {
    for_each_object(root, "views", [&](Fields& fields, std::size_t) {
        View view;
        view.id = reader.take_id(fields);
        fields.optional("name", view.name);
        fields.require("eye", view.eye, "three numbers [x, y, z]");
        fields.require("target", view.target, "three numbers [x, y, z]");
        fields.optional_angle("field_of_view_deg", view.field_of_view);
        fields.optional("orthographic", view.orthographic);
        view.unknown = fields.unknown();
        reader.scene.views.push_back(std::move(view));
    });
}

}  // namespace hanei
