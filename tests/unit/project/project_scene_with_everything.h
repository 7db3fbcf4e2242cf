/// A project in which every kind of object and every field occurs once.
#pragma once

#include "engine/edit/furniture_edits.h"
#include "engine/project/project_file.h"

namespace hanei {

inline Photometry photometry_with_everything(ObjectId id) {
    Photometry photometry;
    photometry.id = id;
    photometry.name = "louvre \"600\"";
    photometry.source_file = "louvre.ies";
    photometry.format = "LM-63-2002";
    photometry.type = PhotometricType::B;
    photometry.symmetry = PhotometricSymmetry::plane_90;
    photometry.horizontal_deg = {90, 112.5, 270};
    photometry.vertical_deg = {0, 1.0 / 3.0, 90};
    photometry.candela = {1, 2, 3, 4, 5.000000000000001, 6, 7, 8, 1e-7};
    photometry.opening = {OpeningShape::horizontal_cylinder_90, 0.6, 0.1, 0.05, {{0.05, 0.04, 0.0, 1.0 / 30.0}}};
    photometry.lamp_set = 1;
    photometry.quarter_turns = 3;
    photometry.lamps = 2;
    photometry.lamp_lumens = 3350;
    photometry.absolute = true;
    photometry.input_watts = 36.5;
    photometry.candela_per_figure = 1.1;
    photometry.declared_output_ratio = 0.72;
    photometry.declared_downward_share = 1.0;
    photometry.lamp_sets = {{2, "T16", 3350, "830", "1B", 54}, {-1, "", 0, "", "", 0}};
    photometry.tilt = LampTilt{"", 2, {0, 90}, {1, 0.95}};
    photometry.keywords = {{"TEST", "häuslich\n2"}, {"MORE", ""}};
    photometry.warnings = {"planes 0 and 360 differ"};
    photometry.unknown = R"({"cct_k": 3000})";
    return photometry;
}

inline void add_furniture_of_every_kind(Scene& scene) {
    const ObjectId wood = scene.materials[0].id;
    Furniture desk{scene.new_id(), "desk", {1, 2, 0}, 0.3, {}, R"({"maker": "none"})"};
    desk.parts.push_back({BoxShape{{1.6, 0.8, 0.03}}, {0, 0, 0.71}, 0.0, wood, R"({"grain": "along"})"});
    const SolidShape wedge{{{0, 0, 0}, {0.4, 0, 0}, {0, 0.4, 0}, {0, 0, 0.4}},
                           {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    desk.parts.push_back({wedge, {0, 0, 0}, -1.0, wood, {}});
    scene.furniture.push_back(desk);
    Furniture stool = made_furniture(scene, {"stool", {{"height", 0.7}, {"diameter", 1.0 / 3.0}}});
    stool.id = scene.new_id();
    stool.position = {3, 1, 0};
    stool.unknown = R"({"model": {"finish": "oiled"}})";
    scene.furniture.push_back(stool);
    const Polygon hole{{2.2, 1, 1.2}, {2.2, 1, 1.4}, {2.4, 1, 1.4}};
    FreeSurface screen{scene.new_id(), "screen", {{{2, 1, 1}, {3, 1, 1}, {3, 1, 2}, {2, 1, 2}}, {hole}},
                       wood,           {12.5},   R"({"a": null})"};
    scene.surfaces.push_back(screen);
}

inline void add_luminaires_of_every_kind(Scene& scene) {
    const auto add = [&](Opening opening, Distribution distribution, Output output) -> Luminaire& {
        Luminaire luminaire;
        luminaire.id = scene.new_id();
        luminaire.position = {2, 2, 2};
        luminaire.opening = std::move(opening);
        luminaire.distribution = distribution;
        luminaire.output = output;
        return scene.luminaires.emplace_back(std::move(luminaire));
    };
    const Region square{{{-0.3, -0.3, 0}, {-0.3, 0.3, 0}, {0.3, 0.3, 0}, {0.3, -0.3, 0}}, {}};
    Luminaire& first = add(PointOpening{}, Diffuse{}, LuminousFlux{1000.1});
    first.name = "first";
    first.yaw = 1.0;
    first.tilt = 0.1;
    first.roll = -3.0;
    first.dimming = 0.7;
    first.colour_temperature = 8000.0 / 3.0;
    first.opaque = true;
    scene.control_groups.push_back({scene.new_id(), "row 1", 0.5, 3000.0, {}});
    first.group = scene.control_groups.back().id;
    scene.light_scenes.push_back(
        {scene.new_id(), "Lecture", {{scene.control_groups.back().id, 1.0 / 3.0}}, R"({"key": 1})"});
    first.unknown = R"({"serial": 12345678901234567890, "opening": {"glass": "opal"}})";
    add(PointOpening{}, CosinePower{4.5}, LuminousFlux{10});
    add(LineOpening{{-0.6, 0, 0}, {0.6, 0, 0.1}}, Diffuse{}, LuminousFlux{3200});
    add(PolygonOpening{square}, Diffuse{}, Luminance{2500});
    add(PolyhedronOpening{{{0, 0, 0}, {0.4, 0, 0}, {0, 0.4, 0}, {0, 0, 0.4}},
                          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
                          {1, 0.5, 0, 1}},
        Diffuse{}, LuminousFlux{800});
    add(PolygonOpening{square}, Measured{scene.photometries[0].id}, LuminousFlux{3600});
    add(MeasuredOpening{}, Measured{scene.photometries[0].id}, AsMeasured{});
}

inline void add_arrangements_of_every_kind(Scene& scene) {
    const auto add = [&](const char* name, Layout layout, std::vector<ObjectId> luminaires) {
        scene.arrangements.push_back(
            {scene.new_id(), name, std::move(layout), 0.1, std::move(luminaires), R"({"layout": {"drawn": true}})"});
    };
    add("line", LineLayout{{1, 1, 2}, {3, 1, 2}, 2}, {scene.luminaires[1].id, {}});
    add("field", FieldLayout{{0, 0, 2}, {4, 0, 0}, {0, 3.1, 0}, 1, 2},
        {scene.luminaires[0].id, scene.luminaires[3].id});
    add("circle", CircleLayout{{2, 1.5, 2.1}, 1.0 / 3.0, 1, 0.2, true}, {scene.luminaires[2].id});
}

inline Project project_with_everything() {
    Project project;
    Scene& scene = project.scene;
    scene.title = "Everything – 半影";
    scene.maintenance_factor = 0.8;
    scene.materials.push_back({scene.new_id(), "wood", 1.0 / 3.0, R"({"gloss": 0.1})"});
    scene.materials.push_back({scene.new_id(), "twin", 0.5, {}});
    scene.materials.push_back({scene.new_id(), "twin", 0.6, {}});
    scene.materials[0].tint = {1.6, 0.9, 0.67 / 3.0};  // of luminance 0.99996
    const ObjectId twin = scene.materials[2].id;
    Room room;
    room.id = scene.new_id();
    room.name = "room";
    room.plan = {{0, 0}, {4, 0}, {4, 3.1}, {0, 3.1}};
    room.floor_height = -0.15;
    room.height = 2.8;
    room.floor_material = room.ceiling_material = twin;
    room.wall_materials = {twin, twin, scene.materials[0].id, twin};
    room.sub_areas.push_back({scene.new_id(), "door", Room::wall_face(2), {1, 0}, {2, 2}, twin, R"({"fire": true})"});
    room.sub_areas.push_back({scene.new_id(), "", Room::ceiling_face, {1, 1}, {2, 2}, twin, {}});
    room.unknown = R"({"storey": 3})";
    scene.room = room;
    scene.photometries.push_back(photometry_with_everything(scene.new_id()));
    add_furniture_of_every_kind(scene);
    add_luminaires_of_every_kind(scene);
    add_arrangements_of_every_kind(scene);
    scene.grids.push_back({scene.new_id(), "grid", {0, 0, 0.8}, {4, 0, 0}, {0.1, 3, 0}, 0.3, R"({"task": "reading"})"});
    scene.points.push_back({scene.new_id(), "point", {1, 2, 0.8}, {0, 0.6, 0.8}, {}});
    scene.views.push_back({scene.new_id(), "view", {0.5, 0.5, 1.6}, {2, 2, 1}, 0.9, true, {}, true, Cut{{0, 0.6, 0.8}, 1.25}});
    scene.colour_scale = ColourScale{0.3, 2000.0 / 3.0, "en", true, {100.0, 1000.0 / 3.0}, R"({"palette": "own"})"};
    scene.object_groups.push_back(
        {scene.new_id(), "corner", {scene.furniture[1].id, scene.luminaires[2].id, scene.points[0].id}, R"({"a": 1})"});
    scene.last_id += 7;  // of objects that were deleted
    scene.unknown = R"({"notes": ["a", {"b": 1.50}], "settings": {"sky": "overcast"}})";
    project.settings = {Method::paper, 0.123456789, 4, 0.00123, 0.3, 2};
    return project;
}

}  // namespace hanei
