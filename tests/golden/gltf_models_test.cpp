// Models of furniture and rooms as modellers write them (tests/golden/gltf/models.py), each with the
// import that a person would call sensible.

#include "engine/base/check.h"
#include "engine/project/gltf_import.h"
#include "engine/project/project_file.h"
#include "engine/scene/faces.h"
#include "engine/scene/scene_check.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <numbers>
#include <sstream>
#include <string>

namespace hanei {
namespace {

const std::filesystem::path folder = std::filesystem::path{HANEI_SOURCE} / "tests/golden/gltf";

std::string told(const GltfImport& import) {
    std::string text;
    for (const Diagnostic& finding : import.findings) text += to_text(finding) + '\n';
    return text;
}

bool tells(const GltfImport& import, std::string_view words) { return told(import).find(words) != std::string::npos; }

/// Imported, sound, and kept by a project file.
GltfImport imported(const std::string& name, const GltfImportOptions& options = {}) {
    GltfImport import = import_gltf(folder / name, options);
    HANEI_CHECK(import.scene.has_value());
    EXPECT_FALSE(has_errors(check_scene(*import.scene))) << name;
    const Project project{*import.scene, {}};
    const ProjectRead again = read_project_text(project_text(project), "/nowhere/again.hanei");
    EXPECT_TRUE(again.project.has_value() && *again.project == project) << name;
    return import;
}

/// Enclosed by all shells together, m3.
double volume(const Scene& scene) {
    double sum = 0.0;
    for (const Shell& shell : shells_of(scene))
        for (const std::vector<int>& face : shell.faces)
            for (std::size_t k = 2; k < face.size(); ++k) {
                const auto at = [&](std::size_t i) { return shell.vertices[static_cast<std::size_t>(face[i])]; };
                sum += glm::dot(at(0), glm::cross(at(k - 1), at(k))) / 6.0;
            }
    return sum;
}

Vec3 box_of(const Part& part) {
    const auto* const box = std::get_if<BoxShape>(&part.shape);
    return box == nullptr ? Vec3{0.0} : box->size;
}

constexpr double rounding = 1e-6;  // m, m2, m3: models hold single precision

void expect_near(const Vec3& found, const Vec3& wanted) {
    EXPECT_LT(glm::distance(found, wanted), rounding) << found.x << ' ' << found.y << ' ' << found.z;
}

TEST(GltfModels, a_desk_of_touching_boxes_is_one_piece_that_keeps_its_sizes_and_stands_where_it_stood) {
    const GltfImport import = imported("desk.gltf");
    EXPECT_TRUE(import.findings.empty()) << told(import);
    ASSERT_EQ(import.scene->furniture.size(), 1U);
    const Furniture& desk = import.scene->furniture[0];
    EXPECT_EQ(desk.name, "desk");
    expect_near(desk.position, {2.0, 1.0, 0.0});
    EXPECT_NEAR(desk.rotation, std::numbers::pi / 2.0, rounding);
    ASSERT_EQ(desk.parts.size(), 3U);
    expect_near(box_of(desk.parts[0]), {1.6, 0.8, 0.03});
    expect_near(desk.parts[0].position, {0.0, 0.0, 0.71});
    expect_near(box_of(desk.parts[1]), {0.03, 0.8, 0.71});
    EXPECT_NEAR(volume(*import.scene), 1.6 * 0.8 * 0.03 + 2 * 0.03 * 0.8 * 0.71, rounding);
    ASSERT_EQ(import.scene->materials.size(), 1U);
    const Material& wood = import.scene->materials[0];
    EXPECT_EQ(wood.name, "wood");
    EXPECT_NEAR(wood.reflectance, 0.2126 * 0.5 + 0.7152 * 0.3 + 0.0722 * 0.1, rounding);
    EXPECT_NEAR(wood.reflectance * wood.tint.x, 0.5, rounding);
}

TEST(GltfModels, a_counter_that_is_not_convex_is_one_solid_of_eight_faces) {
    const GltfImport import = imported("counter.glb");
    EXPECT_TRUE(import.findings.empty()) << told(import);
    ASSERT_EQ(import.solids, 1);
    const auto* const solid = std::get_if<SolidShape>(&import.scene->furniture[0].parts[0].shape);
    ASSERT_NE(solid, nullptr);
    EXPECT_EQ(solid->faces.size(), 8U);
    EXPECT_EQ(solid->vertices.size(), 12U);
    EXPECT_NEAR(volume(*import.scene), (2.4 * 0.6 + 0.6 * 1.2) * 0.9, rounding);
    EXPECT_EQ(import.scene->materials[0].reflectance, 0.4);  // metal mirrors what paint would scatter
}

TEST(GltfModels, a_chair_of_stretched_and_mirrored_cubes_is_six_boxes) {
    const GltfImport import = imported("chair.gltf");
    EXPECT_TRUE(import.findings.empty()) << told(import);
    ASSERT_EQ(import.scene->furniture.size(), 1U);
    EXPECT_EQ(import.scene->furniture[0].name, "chair");
    ASSERT_EQ(import.scene->furniture[0].parts.size(), 6U);
    for (const Part& part : import.scene->furniture[0].parts) EXPECT_NE(box_of(part), Vec3{0.0});
    EXPECT_NEAR(volume(*import.scene), 0.4 * 0.04 * 0.4 + 0.4 * 0.4 * 0.03 + 4 * 0.04 * 0.42 * 0.04, rounding);
}

TEST(GltfModels, a_tray_without_a_lid_is_five_sheets_lit_on_both_sides) {
    const GltfImport import = imported("tray.gltf");
    EXPECT_EQ(import.solids, 0);
    EXPECT_EQ(import.sheets, 10);
    double area = 0.0;
    for (const Face& face : faces_of(*import.scene)) {
        const Polygon& p = face.region.outline;
        area += glm::length(glm::cross(p[1] - p[0], p[2] - p[1]));  // all are rectangles
    }
    EXPECT_NEAR(area, 2 * (0.6 * 0.4 + 2 * 0.1 * (0.6 + 0.4)), rounding);
    EXPECT_TRUE(tells(import, "5 faces stand free as surfaces, lit on both sides"));
}

TEST(GltfModels, sheets_of_one_node_arrive_as_a_group_of_its_name_and_a_single_one_alone) {
    const GltfImport tray = imported("tray.gltf");
    ASSERT_EQ(tray.scene->object_groups.size(), 1U);
    EXPECT_EQ(tray.scene->object_groups[0].name, "tray");
    ASSERT_EQ(tray.scene->object_groups[0].members.size(), tray.scene->surfaces.size());
    for (std::size_t k = 0; k < tray.scene->surfaces.size(); ++k)
        EXPECT_EQ(tray.scene->object_groups[0].members[k], tray.scene->surfaces[k].id);
    EXPECT_TRUE(imported("partition.gltf").scene->object_groups.empty());
    EXPECT_TRUE(imported("desk.gltf").scene->object_groups.empty()) << "one piece of furniture is no group";
}

TEST(GltfModels, a_partition_of_one_side_is_one_sheet_and_its_black_back_is_told) {
    const GltfImport import = imported("partition.gltf");
    ASSERT_EQ(import.sheets, 1);
    EXPECT_EQ(import.scene->surfaces[0].name, "partition");
    EXPECT_EQ(import.scene->surfaces[0].region.outline.size(), 4U);
    EXPECT_TRUE(tells(import, "their backs are black"));
    const Face face = faces_of(*import.scene)[0];
    expect_near(face.normal, {0.0, -1.0, 0.0});
}

TEST(GltfModels, a_cabinet_that_is_inside_out_is_turned_round) {
    const GltfImport import = imported("cabinet.glb");
    ASSERT_EQ(import.solids, 1);
    EXPECT_TRUE(tells(import, "inside out"));
    EXPECT_LT(glm::distance(box_of(import.scene->furniture[0].parts[0]), {0.8, 0.4, 2.0}), 1e-4);  // 16 bits of 2 m
    EXPECT_NEAR(volume(*import.scene), 0.8 * 0.4 * 2.0, 1e-4);
}

TEST(GltfModels, triangles_wound_against_the_others_are_turned_and_counted) {
    const GltfImport import = imported("plinth.gltf");
    EXPECT_TRUE(tells(import, "5 triangles are wound against the others"));
    EXPECT_NEAR(volume(*import.scene), 0.25, rounding);
}

TEST(GltfModels, a_shelf_in_millimetres_is_told_and_right_when_its_unit_is_given) {
    const GltfImport doubtful = imported("shelf_in_mm.gltf");
    EXPECT_TRUE(tells(doubtful, "drawn in mm it is 0.94 x 0.3 x 1.8 m"));
    const GltfImport import = imported("shelf_in_mm.gltf", {0.001});
    EXPECT_TRUE(import.findings.empty()) << told(import);
    EXPECT_EQ(import.solids, 6);
    expect_near(import.size, {0.94, 0.3, 1.8});
    EXPECT_NEAR(volume(*import.scene), 4 * 0.9 * 0.3 * 0.02 + 2 * 0.02 * 0.3 * 1.8, rounding);
}

TEST(GltfModels, a_table_of_a_millimetre_keeps_its_shape_and_its_size_is_doubted) {
    const GltfImport import = imported("tiny.glb");
    EXPECT_TRUE(tells(import, "A unit of 1000 m makes it 1.2 x 0.8 x 0.7 m"));
    EXPECT_LT(glm::distance(box_of(import.scene->furniture[0].parts[0]), {1.2e-3, 8e-4, 7e-4}), 1e-9);
    const GltfImport large = imported("tiny.glb", {1000.0});
    EXPECT_TRUE(large.findings.empty()) << told(large);
    EXPECT_NEAR(volume(*large.scene), 1.2 * 0.8 * 0.7, rounding);
}

TEST(GltfModels, an_office_is_a_room_with_its_desk_and_three_lamps) {
    const GltfImport import = imported("office.gltf");
    ASSERT_TRUE(import.scene->room.has_value());
    const Room& room = *import.scene->room;
    EXPECT_EQ(room.plan.size(), 6U);
    EXPECT_NEAR(room.height, 3.0, rounding);
    const auto name = [&](ObjectId id) { return find_material(*import.scene, id)->name; };
    EXPECT_EQ(name(room.floor_material), "carpet");
    EXPECT_EQ(name(room.ceiling_material), "white");
    ASSERT_EQ(import.scene->furniture.size(), 1U);
    expect_near(box_of(import.scene->furniture[0].parts[0]), {1.6, 0.8, 0.74});
    ASSERT_EQ(import.scene->luminaires.size(), 3U);
    EXPECT_EQ(import.scene->luminaires[2].name, "panel");
    expect_near(import.scene->luminaires[2].position, {1.8, -1.4, 2.95});
    EXPECT_NEAR(import.scene->luminaires[2].tilt, 0.0, rounding);
    EXPECT_FALSE(has_errors(import.findings)) << told(import);
    for (const Diagnostic& finding : check_scene(*import.scene)) ADD_FAILURE() << to_text(finding);
}

TEST(GltfModels, as_furniture_a_room_is_a_solid_and_as_a_room_a_desk_is_one) {
    EXPECT_FALSE(imported("office.gltf", {.kind = GltfKind::furniture}).scene->room.has_value());
    const GltfImport import = imported("counter.glb", {.kind = GltfKind::room});
    ASSERT_TRUE(import.scene->room.has_value());
    EXPECT_EQ(import.scene->room->plan.size(), 6U);
    EXPECT_EQ(import.solids, 0);
}

TEST(GltfModels, with_z_up_heights_are_the_files_third_figures) {
    const GltfImport import = imported("cabinet.glb", {.up = GltfUpAxis::z});
    EXPECT_LT(glm::distance(import.size, {0.8, 2.0, 0.4}), 1e-4);
}

TEST(GltfModels, triangles_without_area_or_there_twice_are_left_out_and_a_missing_corner_is_given_back) {
    const GltfImport import = imported("messy.gltf");
    EXPECT_TRUE(tells(import, "\"block\": 2 triangles without area are left out")) << told(import);
    EXPECT_TRUE(tells(import, "\"block\": 3 triangles that are there twice are left out"));
    EXPECT_TRUE(tells(import, "\"block\": 1 triangle is cut"));
    const auto& furniture = import.scene->furniture;
    ASSERT_FALSE(furniture.empty());
    expect_near(box_of(furniture[0].parts[0]), {1.0, 1.0, 1.0});
    // the bow tie crosses itself where no edge is: it is closed, and its faces stand for it in the study
    ASSERT_EQ(furniture.size(), 2U);
    EXPECT_EQ(furniture[1].name, "bow tie");
    EXPECT_EQ(shells_of(*import.scene).back().faces.size(), 8U);
}

/// Cells of a row of index.tsv: file, verdict, what is wrong, a good answer, line, field.
std::vector<std::string> cells(const std::string& row) {
    std::vector<std::string> result;
    std::istringstream stream{row};
    for (std::string cell; std::getline(stream, cell, '\t');) result.push_back(cell);
    result.resize(6);
    return result;
}

TEST(GltfModels, hostile_files_are_refused_in_a_sentence_with_its_place_and_nothing_is_imported) {
    const std::filesystem::path shared = std::filesystem::path{HANEI_SHARED} / "photometry/malformed";
    if (!std::filesystem::exists(shared)) GTEST_SKIP() << "skipped: no " << shared;
    std::ifstream index{shared / "index.tsv"};
    int files = 0;
    for (std::string row; std::getline(index, row);) {
        const std::vector<std::string> demand = cells(row);
        if (!demand[0].starts_with("gltf_")) continue;
        ++files;
        const GltfImport import = import_gltf(shared / demand[0], {});
        EXPECT_EQ(import.scene.has_value(), !has_errors(import.findings)) << demand[0];
        EXPECT_FALSE(demand[1] == "reject" && import.scene) << demand[0];
        const bool placed = std::any_of(import.findings.begin(), import.findings.end(), [&](const Diagnostic& finding) {
            return finding.place.field.find(demand[5]) != std::string::npos;
        });
        EXPECT_TRUE(placed) << demand[0] << ": " << demand[5] << '\n' << told(import);
    }
    EXPECT_EQ(files, 14);
}

}  // namespace
}  // namespace hanei
