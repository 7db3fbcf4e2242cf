#include "engine/project/project_file.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

/// All findings, one a line.
std::string findings_of(const std::string& text) {
    const ProjectRead read = read_project_text(text, "room.hanei");
    EXPECT_NE(read.project.has_value(), has_errors(read.findings));
    std::string lines;
    for (const Diagnostic& finding : read.findings) lines += to_text(finding) + '\n';
    return lines;
}

/// The fields of a project of version 1.
std::string project_of(const std::string& fields) {
    return "{\"format\": \"hanei-project\", \"version\": 1" + (fields.empty() ? "" : ",\n" + fields) + "}";
}

TEST(ProjectFaults, a_newer_version_is_refused_with_a_sentence_and_nothing_else) {
    EXPECT_EQ(
        findings_of("{\"format\": \"hanei-project\",\n\"version\": 7, \"materials\": 3}"),
        "room.hanei:2: version: the file is of version 7, this program reads up to version 1; open it with a newer "
        "hanei\n");
}

TEST(ProjectFaults, a_light_scene_of_a_group_that_is_not_there_is_refused) {
    EXPECT_EQ(findings_of(project_of("\"control_groups\": [{\"name\": \"row\"}],\n\"light_scenes\": [{\"levels\": "
                                     "[{\"group\": \"desk\", \"dimming\": 1}]}]")),
              "room.hanei:3: light_scenes[0].levels[0].group: there is no control group \"desk\"; there are \"row\"\n");
}

TEST(ProjectFaults, a_layout_of_an_unknown_kind_is_refused) {
    EXPECT_EQ(findings_of(project_of("\"arrangements\": [{\"luminaires\": [],\n\"layout\": {\"kind\": \"spiral\"}}]")),
              "room.hanei:3: arrangements[0].layout.kind: found \"spiral\", expected \"line\", \"field\" or "
              "\"circle\"\n");
}

TEST(ProjectFaults, another_kind_of_json_is_refused) {
    EXPECT_EQ(findings_of("{\"cells\": []}"),
              "room.hanei:1: format: this is no hanei project: the field must be \"hanei-project\"\n");
    EXPECT_EQ(findings_of("[1, 2]"),
              "room.hanei:1: format: this is no hanei project: the field must be \"hanei-project\"\n");
    EXPECT_EQ(findings_of("{\"format\": \"hanei-project\"}"),
              "room.hanei:1: version: the field is missing; expected 1\n");
    EXPECT_EQ(findings_of("{\"format\": \"hanei-project\", \"version\": 0}"),
              "room.hanei:1: version: found 0, expected 1\n");
}

TEST(ProjectFaults, wrong_types_are_told_with_line_field_and_what_was_found) {
    EXPECT_EQ(findings_of(project_of(
                  "\"title\": 3,\n\"materials\": [{\"name\": \"a\",\n\"reflectance\": \"half\"}, 7],\n\"views\": {}")),
              "room.hanei:2: title: found 3, expected a text\n"
              "room.hanei:4: materials[0].reflectance: found \"half\", expected a number\n"
              "room.hanei:4: materials[1]: found 7, expected an object {...}\n"
              "room.hanei:5: views: found an object, expected a list\n");
}

TEST(ProjectFaults, missing_fields_are_told_with_what_is_expected) {
    EXPECT_EQ(
        findings_of(project_of("\"luminaires\": [\n{\"name\": \"a\"}]")),
        "room.hanei:3: luminaires[0].position: the field is missing; expected three numbers [x, y, z]\n"
        "room.hanei:3: luminaires[0].opening: the field is missing; expected {\"kind\": \"point\"} or another kind\n"
        "room.hanei:3: luminaires[0].flux_lm: the field is missing; expected \"flux_lm\", \"luminance_cd_m2\" or "
        "\"as_measured\": true\n");
}

TEST(ProjectFaults, a_colour_that_cannot_be_is_told_with_its_line_and_what_could) {
    EXPECT_EQ(
        findings_of(project_of("\"materials\": [{\"name\": \"a\", \"reflectance\": 0.5, \"tint\": \"red\"},\n"
                               "{\"name\": \"b\", \"reflectance\": 0.5,\n\"tint\": [2, 1, 1]},\n"
                               "{\"name\": \"c\", \"reflectance\": 0.5,\n\"tint\": [3, 0.5, 0.064]}]")),
        "room.hanei:2: materials[0].tint: found \"red\", expected three numbers [x, y, z]\n"
        "room.hanei:4: materials[1].tint: material \"b\": found 2, 1, 1 of luminance 1.2126, allowed is a luminance "
        "of 1 (0.2126 red + 0.7152 green + 0.0722 blue); write 1.64935, 0.824674, 0.824674\n"
        "room.hanei:6: materials[2].tint: material \"c\": found 3, 0.5, 0.064: with a reflectance of 0.5 a band "
        "would reflect 1.5, allowed is 1 at most; lower the reflectance to 0.333333 or choose a paler colour\n");
    EXPECT_EQ(
        findings_of(project_of("\"luminaires\": [{\"name\": \"a\", \"position\": [0, 0, 0], \"opening\": {\"kind\": "
                               "\"point\"}, \"flux_lm\": 1,\n\"colour_temperature_k\": 27}]")),
        "room.hanei:3: luminaires[0].colour_temperature_k: luminaire \"a\": found 27 K, allowed are 0 (neutral) and "
        "1000 to 25000 K\n");
}

TEST(ProjectFaults, a_luminaire_with_two_outputs_is_refused) {
    EXPECT_EQ(
        findings_of(project_of("\"luminaires\": [{\"position\": [0, 0, 0], \"opening\": {\"kind\": \"point\"}, "
                               "\"flux_lm\": 1, \"luminance_cd_m2\": 1}]")),
        "room.hanei:2: luminaires[0]: a luminaire has one of \"flux_lm\", \"luminance_cd_m2\" and \"as_measured\"; "
        "keep one\n");
}

TEST(ProjectFaults, a_material_that_is_not_there_is_told_with_those_that_are) {
    EXPECT_EQ(
        findings_of(project_of("\"materials\": [{\"name\": \"oak\", \"reflectance\": 0.3}],\n"
                               "\"surfaces\": [{\"outline\": [[0,0,0],[1,0,0],[0,1,0]], \"material\": \"elm\"}]")),
        "room.hanei:3: surfaces[0].material: there is no material \"elm\"; there are \"oak\"\n");
}

TEST(ProjectFaults, a_name_that_two_materials_have_is_ambiguous) {
    EXPECT_EQ(findings_of(project_of(
                  "\"materials\": [{\"name\": \"a\", \"reflectance\": 0.3}, {\"name\": \"a\", \"reflectance\": 0.4}],\n"
                  "\"surfaces\": [{\"outline\": [[0,0,0],[1,0,0],[0,1,0]], \"material\": \"a\"}]")),
              "room.hanei:3: surfaces[0].material: 2 of the kind material are named \"a\"; refer to it by its id, or "
              "rename\n");
}

TEST(ProjectFaults, duplicate_ids_are_told_with_the_object_that_had_it_first) {
    EXPECT_EQ(
        findings_of(
            project_of("\"materials\": [{\"id\": 5, \"name\": \"a\", \"reflectance\": 0.3}],\n"
                       "\"points\": [{\"id\": 5, \"position\": [0, 0, 0]},\n{\"id\": 0.5, \"position\": [0, 0, 0]}]")),
        "room.hanei:3: points[0].id: the id 5 is already that of materials[0]; leave the field out to get a new one\n"
        "room.hanei:4: points[1].id: found 0.5, expected a whole number from 1 to 4294967294\n");
}

TEST(ProjectFaults, a_field_that_stands_twice_is_an_error) {
    EXPECT_EQ(findings_of(project_of("\"views\": [{\"eye\": [0,0,0],\n\"eye\": [1,0,0], \"target\": [2,0,0]}]")),
              "room.hanei:3: views[0].eye: the field stands here twice; keep one of them\n");
}

TEST(ProjectFaults, figures_that_no_double_holds_are_refused) {
    EXPECT_EQ(findings_of(project_of("\"maintenance_factor\":\n1e999")),
              "room.hanei:3: maintenance_factor: number overflow parsing '1e999': the number is too large, at most "
              "1.79e308 is "
              "possible\n");
}

TEST(ProjectFaults, broken_json_is_told_with_its_line) {
    const std::string nan = findings_of(project_of("\"maintenance_factor\":\nNaN"));
    EXPECT_EQ(nan.rfind("room.hanei:3: maintenance_factor: this is no valid JSON: invalid literal", 0), 0U) << nan;
    const std::string cut = findings_of("{\"format\":\n\n\"hanei");
    EXPECT_EQ(cut.rfind("room.hanei:3: format: this is no valid JSON: invalid string: missing closing quote", 0), 0U)
        << cut;
    const std::string empty = findings_of("");
    EXPECT_NE(empty.find("unexpected end of input"), std::string::npos) << empty;
    const std::string latin = findings_of("{\"format\": \"caf\xe9\"}");
    EXPECT_NE(latin.find("ill-formed UTF-8"), std::string::npos) << latin;
    EXPECT_EQ(latin.find('\xe9'), std::string::npos);
}

TEST(ProjectFaults, a_file_that_nests_without_end_is_refused) {
    const std::string deep = findings_of(project_of("\"x\": " + std::string(100'000, '[')));
    EXPECT_NE(deep.find("nested deeper than 64 levels"), std::string::npos) << deep.substr(0, 500);
}

TEST(ProjectFaults, settings_out_of_range_are_told_with_what_is_allowed) {
    EXPECT_EQ(findings_of(project_of("\"settings\": {\"method\": \"guess\",\n\"max_patch\": 0, \"bounces\": 2.5,\n"
                                     "\"accuracy_percent\": 99}")),
              "room.hanei:2: settings.method: found \"guess\", expected one of \"paper\", \"paper-closed\", \"patch\", "
              "\"linear\"\n"
              "room.hanei:3: settings.max_patch: found 0, allowed are 0.01 to 50 m\n"
              "room.hanei:3: settings.bounces: found 2.5, expected a whole number\n"
              "room.hanei:4: settings.accuracy_percent: found 99, allowed are 1e-07 to 50 percent\n");
}

TEST(ProjectFaults, faults_of_the_scene_have_their_line_too) {
    EXPECT_EQ(findings_of(project_of("\"materials\": [\n{\"name\": \"a\",\n \"reflectance\": 1.5}],\n"
                                     "\"views\": [{\"name\": \"v\", \"eye\": [1,1,1],\n\"target\": [1,1,1]}]")),
              "room.hanei:4: materials[0].reflectance: material \"a\": found 1.5, allowed are 0 to 1\n"
              "room.hanei:6: views[0].target: view \"v\": eye and target are the same place; move one of them\n");
}

TEST(ProjectFaults, what_only_follows_from_another_fault_is_not_told) {
    EXPECT_EQ(findings_of(project_of(
                  "\"room\": {\"plan\": [[0, 0], [1, 0], [0, \"x\"]], \"height\": 2, \"floor\": \"a\", "
                  "\"ceiling\": \"a\", \"walls\": []},\n\"materials\": [{\"name\": \"a\", \"reflectance\": 2}]")),
              "room.hanei:2: room.plan[2][1]: found \"x\", expected a number\n"
              "room.hanei:3: materials[0].reflectance: material \"a\": found 2, allowed are 0 to 1\n");
}

TEST(ProjectFaults, a_photometry_has_four_sides_its_own_lamp_sets_and_less_than_a_full_turn) {
    EXPECT_EQ(findings_of(project_of("\"photometries\": [{\"name\": \"p\", \"type\": \"C\", \"symmetry\": \"none\", "
                                     "\"opening\": {\"shape\": \"box\", \"side_heights\": [1, 2]},\n"
                                     "\"lamp_sets\": [{\"lumens_lm\": 1}], \"lamp_set\": 1,\n\"quarter_turns\": 4,\n"
                                     "\"horizontal_deg\": [0], \"vertical_deg\": [0, 90], \"candela\": [[1, 2]]}]")),
              "room.hanei:2: photometries[0].opening.side_heights: found 2 heights, expected 4: of the sides at planes "
              "0, 90, 180 and 270\n"
              "room.hanei:3: photometries[0].lamp_set: found 1, the photometry has 1 lamp sets, counted from 0\n"
              "room.hanei:4: photometries[0].quarter_turns: found 4, expected 0, 1, 2 or 3\n");
}

TEST(ProjectFaults, a_candela_table_must_match_its_angles) {
    EXPECT_EQ(
        findings_of(
            project_of("\"photometries\": [{\"name\": \"p\", \"type\": \"C\", \"symmetry\": \"none\", "
                       "\"opening\": {\"shape\": \"triangle\"},\n\"horizontal_deg\": [0], \"vertical_deg\": [0, 90],\n"
                       "\"candela\": [[1, 2, 3]]}]")),
        "room.hanei:2: photometries[0].opening.shape: found \"triangle\", expected one of \"point\", \"rectangle\", "
        "\"circle\", \"ellipse\", \"box\", \"vertical cylinder\", \"horizontal cylinder\", \"sphere\", \"ellipsoid\", "
        "\"vertical disc\", \"horizontal cylinder 90\"\n"
        "room.hanei:4: photometries[0].candela: plane 0: 2 vertical angles announced, 3 values found\n");
}

TEST(ProjectFaults, luminaire_files_are_named_relative_to_the_project) {
    const std::string absolute = findings_of(project_of("\"photometries\": [{\"file\": \"/etc/passwd\"}]"));
    EXPECT_NE(absolute.find("expected a path relative to the project file's folder"), std::string::npos) << absolute;
    const std::string missing = findings_of(project_of("\"photometries\": [{\"file\": \"no such file.ies\"}]"));
    EXPECT_NE(missing.find("photometries[0].file: the luminaire file \"no such file.ies\" cannot be used"),
              std::string::npos)
        << missing;
}

TEST(ProjectFaults, walls_are_counted_from_nought_and_called_by_name) {
    const std::string start =
        "\"materials\": [{\"name\": \"a\", \"reflectance\": 0.5}],\n\"room\": {\"plan\": [[0,0],[1,0],[0,1]], "
        "\"height\": 2, \"floor\": \"a\", \"ceiling\": \"a\", \"walls\": \"a\", \"sub_areas\": [\n";
    for (const std::string face : {"wall", "wall -1", "wall 1x", "roof", ""}) {
        const std::string found = findings_of(project_of(
            start + "{\"face\": \"" + face + "\", \"low\": [0,0], \"high\": [0.5,1], \"material\": \"a\"}]}"));
        EXPECT_EQ(found, "room.hanei:4: room.sub_areas[0].face: found \"" + face +
                             "\", expected \"floor\", \"ceiling\" or \"wall 0\", \"wall 1\", ...\n");
    }
    const std::string beyond = findings_of(project_of(
        start +
        "{\"name\": \"door\", \"face\": \"wall 3\", \"low\": [0,0], \"high\": [0.5,1], \"material\": \"a\"}]}"));
    EXPECT_EQ(
        beyond,
        "room.hanei:4: room.sub_areas[0].face: sub-area \"door\": the room has no such wall; there are 3, counted "
        "from 0\n");
}

}  // namespace
}  // namespace hanei
