// Files of the exporter that another program changed: what the meshes show wins over what was written
// beside them, and what cannot be is refused in a sentence.

#include "engine/edit/furniture_edits.h"
#include "engine/project/gltf_export.h"
#include "engine/project/gltf_import.h"
#include "engine/project/project_file.h"
#include "tests/unit/project/project_scene_with_everything.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <numbers>

namespace hanei {
namespace {

using json = nlohmann::ordered_json;  // unknown fields keep their order

constexpr double single = 2e-6;  // m: single precision of places some metres from the origin

std::string told(const Diagnostics& findings) {
    std::string text;
    for (const Diagnostic& finding : findings) text += to_text(finding) + '\n';
    return text;
}

/// A desk of the library, a lamp, and a screen in a group with the desk.
class Edited : public testing::Test {
protected:
    Edited() : scene(project_with_everything().scene) {
        const Added added = with_furniture(std::move(scene), {"desk", {{"width", 1.4}}}, {2.0, 0.6, -0.15}, 0.4);
        scene = added.scene;
        desk = added.object;
        screen = scene.surfaces[0].id;
        scene.object_groups.push_back({scene.new_id(), "desk and screen", {desk, screen}, {}});
        file = json::parse(gltf_file({scene, {}}, nullptr, false));
        scene = read();  // numbers of more digits than a double has were rounded by the JSON of this test
    }

    json& node(const std::string& kind, ObjectId id) {
        for (json& each : file["nodes"])
            if (each["extras"]["hanei"]["kind"] == kind && each["extras"]["hanei"]["id"] == id.value) return each;
        ADD_FAILURE() << "no node " << kind << ' ' << id.value;
        return file["nodes"][0];
    }
    std::size_t number_of(const json& node) const { return static_cast<std::size_t>(&node - &file["nodes"][0]); }
    void hide(const json& node) {
        json& shown = file["scenes"][0]["nodes"];
        shown.erase(std::find(shown.begin(), shown.end(), number_of(node)));
    }
    void show_again(json node) {
        file["scenes"][0]["nodes"].push_back(file["nodes"].size());
        file["nodes"].push_back(std::move(node));
    }
    const Scene& read() {
        import = import_gltf(file.dump(), "edited.gltf", {}, {});
        EXPECT_TRUE(import.scene.has_value()) << told(import.findings);
        if (!import.scene) import.scene.emplace();
        return *import.scene;
    }
    const Furniture* furniture(ObjectId id) const {
        for (const Furniture& each : import.scene->furniture)
            if (each.id == id) return &each;
        return nullptr;
    }

    Scene scene;
    ObjectId desk, screen;
    json file;
    GltfImport import;
};

TEST_F(Edited, a_desk_that_was_moved_and_turned_is_still_that_desk) {
    json& its = node("furniture", desk);
    its["translation"] = {1.5, 0.0, -1.25};
    its["rotation"] = {0.0, std::sin(0.5), 0.0, std::cos(0.5)};
    read();
    const Furniture* const found = furniture(desk);
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->position, (Vec3{1.5, 1.25, 0.0}));
    EXPECT_NEAR(found->rotation, 1.0, 1e-9);  // tidied to 1e-8 degrees
    EXPECT_EQ(found->model.kind, "desk");
    EXPECT_EQ(found->parts, scene.furniture.back().parts);
    EXPECT_EQ(import.scene->object_groups, scene.object_groups);
}

TEST_F(Edited, a_desk_that_was_stretched_has_the_shape_of_its_mesh_and_no_model) {
    node("furniture", desk)["scale"] = {2.0, 1.0, 1.0};
    read();
    const Furniture* const found = furniture(desk);
    ASSERT_NE(found, nullptr) << "it keeps its id";
    EXPECT_EQ(found->name, scene.furniture.back().name);
    EXPECT_TRUE(found->model.kind.empty());
    EXPECT_NEAR(own_bounds(*found).high.x, 1.4, single);  // half of 2 x 1.4 m
    EXPECT_EQ(import.scene->object_groups, scene.object_groups);
    EXPECT_NE(told(import.findings)
                  .find("its mesh was changed since it was exported; the mesh is taken; it is no \"desk\" of the "
                        "furniture library any more"),
              std::string::npos)
        << told(import.findings);
}

TEST_F(Edited, a_screen_that_was_moved_keeps_its_hole_and_what_it_emits) {
    node("surface", screen)["translation"] = {0.5, 0.25, 0.0};
    read();
    ASSERT_EQ(import.scene->surfaces.size(), 1U);
    const FreeSurface& found = import.scene->surfaces[0];
    EXPECT_EQ(found.id, screen);
    EXPECT_EQ(found.region.outline[0], (scene.surfaces[0].region.outline[0] + Vec3{0.5, 0.0, 0.25}));
    EXPECT_EQ(found.region.holes.size(), 1U);
    EXPECT_EQ(found.own_exitance.value, 12.5);
}

TEST_F(Edited, a_room_that_was_made_higher_is_taken_and_says_that_its_sub_areas_are_lost) {
    node("room", scene.room->id)["scale"] = {1.0, 1.5, 1.0};
    read();
    ASSERT_TRUE(import.scene->room.has_value());
    EXPECT_EQ(import.scene->room->id, scene.room->id);
    EXPECT_NEAR(import.scene->room->height, 4.2, single);
    EXPECT_TRUE(import.scene->room->sub_areas.empty());
    EXPECT_NE(told(import.findings).find("its 2 sub-areas on walls, floor and ceiling are left out"), std::string::npos)
        << told(import.findings);
}

TEST_F(Edited, what_was_deleted_is_left_out_of_groups_and_arrangements_and_named) {
    hide(node("furniture", desk));
    hide(node("luminaire", scene.arrangements[0].luminaires[0]));
    read();
    EXPECT_EQ(furniture(desk), nullptr);
    EXPECT_EQ(import.scene->luminaires.size(), scene.luminaires.size() - 1);
    EXPECT_EQ(import.scene->object_groups.back().members, std::vector<ObjectId>{screen});
    EXPECT_EQ(import.scene->arrangements.size(), scene.arrangements.size() - 1) << "the line had no other lamp";
    EXPECT_NE(told(import.findings).find("no node shows \"Desk\" any more"), std::string::npos)
        << told(import.findings);
}

TEST_F(Edited, a_copy_of_a_node_is_a_copy_of_its_object_wherever_the_file_lists_it) {
    json& original = node("furniture", desk);
    const json as_it_was = original;
    original["translation"] = {3.0, 0.0, -2.0};
    original["name"] = "Desk.001";
    show_again(as_it_was);
    json lamp = node("luminaire", scene.luminaires[0].id);
    lamp["translation"][1] = 1.0;
    show_again(lamp);
    read();
    ASSERT_EQ(import.scene->furniture.size(), scene.furniture.size() + 1);
    EXPECT_EQ(*furniture(desk), scene.furniture.back()) << "the one that stands where it stood";
    const Furniture& copy = import.scene->furniture.back();
    EXPECT_GT(copy.id.value, scene.last_id);
    EXPECT_EQ(copy.model, scene.furniture.back().model);
    EXPECT_EQ(copy.position, (Vec3{3.0, 2.0, 0.0}));
    ASSERT_EQ(import.scene->luminaires.size(), scene.luminaires.size() + 1);
    EXPECT_EQ(import.scene->luminaires[0], scene.luminaires[0]);
    EXPECT_EQ(import.scene->luminaires.back().position.z, 1.0);
    EXPECT_EQ(import.scene->luminaires.back().group, scene.luminaires[0].group);
    EXPECT_EQ(import.scene->arrangements, scene.arrangements);
}

TEST_F(Edited, a_colour_that_was_changed_is_that_of_the_material_everywhere) {
    const Material wood = scene.materials[0];
    for (json& each : file["materials"])
        if (each["extras"]["hanei"]["id"] == wood.id.value)
            each["pbrMetallicRoughness"]["baseColorFactor"] = {0.25, 0.25, 0.25, 1.0};
    read();
    EXPECT_EQ(import.scene->materials.size(), scene.materials.size());
    EXPECT_EQ(import.scene->materials[0].id, wood.id);
    EXPECT_EQ(import.scene->materials[0].reflectance, 0.25);
    EXPECT_EQ(import.scene->materials[0].tint, Vec3(1.0));
    EXPECT_EQ(import.scene->furniture, scene.furniture) << "models and parts stay";
    EXPECT_EQ(import.scene->surfaces, scene.surfaces);
}

TEST_F(Edited, a_name_that_was_changed_is_taken_but_not_a_number_behind_it) {
    node("furniture", desk)["name"] = "Manager";
    node("surface", screen)["name"] = "screen.002";
    read();
    EXPECT_EQ(furniture(desk)->name, "Manager");
    EXPECT_EQ(import.scene->surfaces, scene.surfaces);
}

TEST_F(Edited, objects_that_were_hung_below_an_empty_node_are_what_they_were) {
    json& shown = file["scenes"][0]["nodes"];
    const json children = shown;
    shown = json::array({file["nodes"].size()});
    file["nodes"].push_back({{"name", "Everything"}, {"children", children}});
    EXPECT_EQ(read(), scene);
}

TEST_F(Edited, a_mesh_added_by_another_program_joins_what_was_written) {
    json box = node("furniture", desk);
    box.erase("extras");
    box["name"] = "copied without its extras";
    box["translation"] = {0.8, 0.0, -0.8};
    show_again(box);
    read();
    ASSERT_EQ(import.scene->furniture.size(), scene.furniture.size() + 1);
    EXPECT_TRUE(import.scene->furniture.back().model.kind.empty());
    EXPECT_EQ(*furniture(desk), scene.furniture.back());
}

struct Hostile {
    const char* pointer;   ///< where in the file
    const char* value;     ///< JSON that stands there instead
    const char* sentence;  ///< part of what is said
};

void PrintTo(const Hostile& hostile, std::ostream* out) { *out << hostile.pointer << " = " << hostile.value; }

class HostileExtras : public Edited, public testing::WithParamInterface<Hostile> {};

TEST_P(HostileExtras, are_refused_in_a_sentence_with_its_place_and_nothing_is_loaded) {
    const Hostile& hostile = GetParam();
    file[json::json_pointer(hostile.pointer)] = "@";
    std::string text = file.dump();
    text.replace(text.find("\"@\""), 3, hostile.value);
    import = import_gltf(text, "hostile.gltf", {}, {});
    EXPECT_FALSE(import.scene.has_value());
    EXPECT_NE(told(import.findings).find(hostile.sentence), std::string::npos) << told(import.findings);
    const auto errors = std::count_if(import.findings.begin(), import.findings.end(),
                                      [](const Diagnostic& each) { return each.severity == Severity::error; });
    EXPECT_EQ(errors, 1) << told(import.findings);
}

INSTANTIATE_TEST_SUITE_P(
    Each, HostileExtras,
    testing::Values(
        Hostile{"/extras/hanei/project", "[]", "extras.hanei.project: found a list of 0, expected an object"},
        Hostile{"/extras/hanei/project/version", "99", "extras.hanei.project.version: the file is of version 99"},
        Hostile{"/extras/hanei/scene", "7", "extras.hanei.scene: found 7"},
        Hostile{"/extras/hanei/project/views", "{}", "extras.hanei.project.views: found an object"},
        Hostile{"/extras/hanei/project/materials/0/reflectance", "1e999", "number"},
        Hostile{"/extras/hanei/project/materials/0/reflectance", "\"dark\"",
                "extras.hanei.project.materials[0].reflectance: found \"dark\", expected a number"},
        Hostile{"/extras/hanei/project/points/0/position", "[null, 0, 0]",
                "extras.hanei.project.points[0].position[0]: found null, expected a number"},
        Hostile{"/extras/hanei/project/object_groups/1/members/0", "4000",
                "extras.hanei.project.object_groups[1].members[0]: found 4000"},
        Hostile{"/extras/hanei/project/object_groups/1/members/0", "\"corner\"",
                "extras.hanei.project.object_groups[1].members[0]: found \"corner\", expected the id or name of"},
        Hostile{"/extras/hanei/project/object_groups/1/members/1", "\"point\"", "the object is in a group already"},
        Hostile{"/extras/hanei/project/arrangements/0/luminaires/0", "4000", "there is no luminaire 4000"},
        Hostile{"/extras/hanei/project/light_scenes/0/levels/0/group", "\"row 9\"", "control group"},
        Hostile{"/extras/hanei/project/furniture/0/id", "1", "the id 1 is already that of"},
        Hostile{"/extras/hanei/project/furniture/2/model/sizes/width", "99", "found 99, allowed is"},
        Hostile{"/extras/hanei/project/colour_scale/low_lx", "-5", "colour_scale"},
        Hostile{"/extras/hanei/project/views/0/eye", "[0, 0]", "extras.hanei.project.views[0].eye: found a list of 2"},
        Hostile{"/nodes/0/extras/hanei/kind", "\"sofa\"", "nodes[0].extras.hanei.kind: found \"sofa\""},
        Hostile{"/nodes/0/extras/hanei/kind", "5", "nodes[0].extras.hanei.kind: found 5, expected a text"},
        Hostile{"/nodes/1/extras/hanei/id", "4000", "which is no furniture of extras.hanei.project"},
        Hostile{"/nodes/1/extras/hanei/id", "-1.5", "nodes[1].extras.hanei.id: found -1.5, expected a whole number"},
        Hostile{"/materials/0/extras/hanei/id", "\"wood\"", "materials[0].extras.hanei.id: found \"wood\""}));

TEST_F(Edited, extras_that_are_no_object_are_those_of_another_program) {
    file["extras"]["hanei"] = "yes";
    for (json& each : file["nodes"]) each["extras"]["hanei"] = {1, 2};
    read();
    EXPECT_TRUE(import.scene->room.has_value());
    EXPECT_TRUE(import.scene->views.empty());
}

}  // namespace
}  // namespace hanei
