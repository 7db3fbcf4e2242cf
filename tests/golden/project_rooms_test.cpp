/// The rooms that come with the program, and projects of former versions.
#include "engine/project/json_value.h"
#include "engine/project/project_file.h"
#include "engine/project/text_file.h"
#include "tests/unit/project/project_scene_with_everything.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <vector>

namespace hanei {
namespace {

const std::filesystem::path source = HANEI_SOURCE;

std::vector<std::filesystem::path> rooms() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(source / "assets/rooms"))
        if (entry.path().extension() == ".hanei") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::string text_of(const std::filesystem::path& file) {
    Diagnostics findings;
    return read_text_file(file, findings).value_or("");
}

TEST(ProjectRooms, there_are_a_computer_room_in_two_lights_and_an_office) {
    std::set<std::string> names;
    for (const auto& file : rooms()) names.insert(file.stem().string());
    EXPECT_TRUE(names.contains("computer-room-panels"));
    EXPECT_TRUE(names.contains("computer-room-window"));
    EXPECT_TRUE(names.contains("office"));
}

TEST(ProjectRooms, every_room_is_read_without_a_finding) {
    for (const auto& file : rooms()) {
        const ProjectRead read = read_project(file);
        EXPECT_TRUE(read.project.has_value());
        for (const Diagnostic& finding : read.findings) ADD_FAILURE() << to_text(finding);
    }
}

TEST(ProjectRooms, every_room_is_saved_as_the_same_text_and_read_as_an_equal_project) {
    for (const auto& file : rooms()) {
        const std::string text = text_of(file);
        const ProjectRead read = read_project_text(text, file);
        ASSERT_TRUE(read.project.has_value()) << file;
        EXPECT_EQ(project_text(*read.project), text) << file;
        EXPECT_EQ(read_project_text(project_text(*read.project), file).project, read.project) << file;
    }
}

TEST(ProjectRooms, every_room_can_be_looked_at_measured_and_lit) {
    for (const auto& file : rooms()) {
        const ProjectRead read = read_project(file);
        ASSERT_TRUE(read.project.has_value()) << file;
        const Scene& scene = read.project->scene;
        EXPECT_GE(scene.views.size(), 3U) << file;
        EXPECT_GE(scene.grids.size(), 1U) << file;
        EXPECT_GE(scene.points.size(), 3U) << file;
        EXPECT_GE(scene.luminaires.size(), 1U) << file;
    }
}

TEST(ProjectRooms, the_computer_rooms_differ_in_their_light_alone) {
    const ProjectRead window = read_project(source / "assets/rooms/computer-room-window.hanei");
    const ProjectRead panels = read_project(source / "assets/rooms/computer-room-panels.hanei");
    ASSERT_TRUE(window.project.has_value() && panels.project.has_value());
    EXPECT_EQ(window.project->scene.furniture, panels.project->scene.furniture);
    EXPECT_EQ(window.project->scene.room, panels.project->scene.room);
    EXPECT_NE(window.project->scene.luminaires, panels.project->scene.luminaires);
    EXPECT_EQ(window.project->settings.bounces, 4);
}

TEST(ProjectRooms, every_room_satisfies_the_schema) {
    if (std::system("python3 -c 'import jsonschema' 2>/dev/null") != 0)
        GTEST_SKIP() << "skipped: no python3-jsonschema";
    for (const auto& file : rooms()) {
        const std::string command =
            "python3 -c 'import json, jsonschema, sys; jsonschema.validate(*[json.load(open(f)) for f "
            "in sys.argv[1:]])' '" +
            file.string() + "' '" + (source / "assets/hanei-project.schema.json").string() + "'";
        EXPECT_EQ(std::system(command.c_str()), 0) << file;
    }
}

/// Names of all properties that a schema describes anywhere.
void collect_properties(const JsonValue& schema, std::set<std::string>& names) {
    for (std::size_t i = 0; i < schema.items.size(); ++i) {
        if (schema.is(JsonValue::Kind::object) && schema.keys[i] == "properties")
            names.insert(schema.items[i].keys.begin(), schema.items[i].keys.end());
        collect_properties(schema.items[i], names);
    }
}

void collect_keys(const JsonValue& value, std::set<std::string>& names) {
    names.insert(value.keys.begin(), value.keys.end());
    for (const JsonValue& item : value.items) collect_keys(item, names);
}

TEST(ProjectRooms, the_schema_lists_every_field_that_is_written) {
    Diagnostics findings;
    const auto schema = parse_json(text_of(source / "assets/hanei-project.schema.json"), "schema", findings);
    ASSERT_TRUE(schema.has_value());
    std::set<std::string> described, written;
    collect_properties(*schema, described);
    Project project = project_with_everything();
    const auto root = parse_json(project_text(project), "project", findings);
    ASSERT_TRUE(root.has_value());
    collect_keys(*root, written);
    for (const char* unknown : {"notes", "b", "sky", "glass", "serial", "maker", "grain", "a", "cct_k", "gloss", "fire",
                                "storey", "task", "drawn", "finish", "key", "palette"})
        written.erase(unknown);
    written.erase("diameter");  // sizes of furniture go by the names of its library
    for (const std::string& name : written) EXPECT_TRUE(described.contains(name)) << name;
}

TEST(ProjectVersions, a_hand_written_project_of_version_1_is_read_for_ever) {
    const ProjectRead read = read_project(source / "tests/golden/projects/version-1.hanei");
    ASSERT_TRUE(read.project.has_value());
    ASSERT_EQ(read.findings.size(), 1U);
    EXPECT_EQ(read.findings[0].place.line, 6);
    EXPECT_EQ(read.findings[0].place.field, "materials[1].sound_absorption");
    const Scene& scene = read.project->scene;
    EXPECT_EQ(scene.materials[1].unknown, "{\"sound_absorption\": 0.35}");
    EXPECT_EQ(scene.room->wall_materials, std::vector<ObjectId>(4, scene.materials[0].id));
    EXPECT_EQ(scene.luminaires[1].tilt, 20.0 * std::numbers::pi / 180.0);
    EXPECT_EQ(std::get<Measured>(scene.luminaires[1].distribution).photometry, scene.photometries[0].id);
    EXPECT_EQ(scene.photometries[0].candela, (std::vector<double>{2400, 1300, 200, 0}));
    EXPECT_EQ(read.project->settings.method, Method::paper);
    EXPECT_EQ(read_project_text(project_text(*read.project), "again").project, read.project);
}

TEST(ProjectFiles, a_luminaire_file_beside_the_project_is_embedded_on_saving) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "hanei project files";
    std::filesystem::create_directories(folder);
    std::filesystem::copy_file(source / "assets/photometry/downlight.ies", folder / "downlight.ies",
                               std::filesystem::copy_options::overwrite_existing);
    ASSERT_FALSE(
        write_text_file(folder / "by path.hanei",
                        R"({"format": "hanei-project", "version": 1, "photometries": [{"file": "downlight.ies"}]})"));
    const ProjectRead read = read_project(folder / "by path.hanei");
    ASSERT_TRUE(read.project.has_value());
    ASSERT_FALSE(write_project(*read.project, folder / "saved.hanei"));
    std::filesystem::remove(folder / "downlight.ies");
    EXPECT_EQ(read_project(folder / "saved.hanei").project, read.project);
    EXPECT_FALSE(std::filesystem::exists(folder / "saved.hanei.part"));
    std::filesystem::remove_all(folder);
}

TEST(ProjectFiles, one_luminaire_of_a_container_is_asked_for_by_its_name) {
    const std::filesystem::path luminaires = source / "tests/golden/luminaires";
    const auto read = [&luminaires](const std::string& photometry) {
        return read_project_text(R"({"format": "hanei-project", "version": 1, "photometries": [)" + photometry + "]}",
                                 luminaires / "p.hanei");
    };
    const std::string file = R"({"file": "containers/two_emitters_bom.gldf")";
    const ProjectRead second = read(file + R"(, "luminaire": "V / e2, emergency only"})");
    ASSERT_TRUE(second.project.has_value());
    EXPECT_EQ(second.project->scene.photometries.front().name, "V / e2, emergency only");
    EXPECT_FALSE(read(file + "}").project.has_value());
    EXPECT_FALSE(read(file + R"(, "luminaire": "V / e3"})").project.has_value());
}

TEST(ProjectFiles, a_luminaire_file_is_taken_with_the_lamp_set_and_the_turn_the_project_asks_for) {
    const ProjectRead read =
        read_project_text(R"({"format": "hanei-project", "version": 1, "photometries": [)"
                          R"({"file": "none_isym0_two_sets.ldt", "lamp_set": 1, "quarter_turns": 3}]})",
                          source / "tests/golden/luminaires/synthetic/p.hanei");
    ASSERT_TRUE(read.project.has_value());
    const Photometry& photometry = read.project->scene.photometries.front();
    EXPECT_EQ(photometry.lamp_set, 1U);
    EXPECT_EQ(photometry.lamp_lumens, photometry.lamp_sets[1].lumens);
    EXPECT_NE(photometry.lamp_lumens, photometry.lamp_sets[0].lumens);
    EXPECT_EQ(photometry.quarter_turns, 3);
}

TEST(ProjectFiles, what_is_no_file_is_refused_with_its_reason) {
    const auto reason = [](const std::filesystem::path& file) {
        const ProjectRead read = read_project(file);
        return read.findings.size() == 1 ? read.findings[0].message : "";
    };
    EXPECT_EQ(reason(source / "assets"), "this is a folder, expected a file");
    EXPECT_EQ(reason(source / "assets/rooms/no such room.hanei"), "there is no such file");
    EXPECT_EQ(reason("/dev/null"), "this is no ordinary file");
    EXPECT_EQ(reason(""), "there is no such file");
}

TEST(ProjectFiles, a_file_above_64_mb_is_refused_before_it_is_read) {
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "hanei-large.hanei";
    ASSERT_FALSE(write_text_file(file, "{}"));
    std::filesystem::resize_file(file, 65U * 1024U * 1024U);
    const ProjectRead read = read_project(file);
    std::filesystem::remove(file);
    ASSERT_EQ(read.findings.size(), 1U);
    EXPECT_EQ(read.findings[0].message, "the file has 65 MB, at most 64 MB can be read");
}

TEST(ProjectFiles, a_project_that_cannot_be_written_says_so_and_leaves_nothing_behind) {
    const auto fault = write_project({}, "/no such folder/room.hanei");
    ASSERT_TRUE(fault.has_value());
    EXPECT_NE(fault->message.find("folder"), std::string::npos) << fault->message;
    Project project;
    project.scene.maintenance_factor = std::numeric_limits<double>::quiet_NaN();
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "hanei-nan.hanei";
    ASSERT_TRUE(write_project(project, file).has_value());
    EXPECT_FALSE(std::filesystem::exists(file));
}

}  // namespace
}  // namespace hanei
