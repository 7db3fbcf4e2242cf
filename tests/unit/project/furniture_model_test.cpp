#include "engine/edit/furniture_edits.h"
#include "engine/project/project_file.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

ProjectRead read_furniture(const std::string& fields) {
    return read_project_text("{\"format\": \"hanei-project\", \"version\": 1,\n\"furniture\": [\n{" + fields + "}]}",
                             "room.hanei");
}

std::string findings_of(const std::string& fields) {
    std::string lines;
    for (const Diagnostic& finding : read_furniture(fields).findings) lines += to_text(finding) + '\n';
    return lines;
}

TEST(AFurnitureModelInAFile, makes_the_parts_that_the_file_leaves_out) {
    const ProjectRead read =
        read_furniture(R"("position": [1, 2, 0], "model": {"kind": "desk", "sizes": {"width": 1.8}})");
    ASSERT_TRUE(read.project);
    EXPECT_TRUE(read.findings.empty());
    const Furniture& desk = read.project->scene.furniture.front();
    EXPECT_TRUE(follows_model(desk));
    EXPECT_EQ(std::get<BoxShape>(desk.parts.front().shape).size.x, 1.8);
    EXPECT_EQ(read.project->scene.materials.size(), 3U);
}

TEST(AFurnitureModelInAFile, that_its_parts_differ_from_is_left_out_with_a_warning) {
    const std::string text = R"("position": [1, 2, 0], "name": "old desk",
"model": {"kind": "desk"}, "parts": [])";
    EXPECT_NE(findings_of(text).find("room.hanei:4: furniture[0].model: warning: furniture \"old desk\": its parts are "
                                     "not those of the library's \"desk\" in these sizes; they are kept as they are, "
                                     "and the model is left out"),
              std::string::npos)
        << findings_of(text);
    EXPECT_TRUE(read_furniture(text).project->scene.furniture.front().model.kind.empty());
}

TEST(AFurnitureModelInAFile, of_an_unknown_kind_stays_with_a_warning) {
    const std::string text = R"("position": [1, 2, 0], "model": {"kind": "hammock", "sizes": {"length": 3}})";
    EXPECT_NE(findings_of(text).find("the library has no \"hammock\""), std::string::npos);
    const ProjectRead read = read_furniture(text);
    EXPECT_EQ(read.project->scene.furniture.front().model.kind, "hammock");
    const ProjectRead again = read_project_text(project_text(*read.project), "room.hanei");
    EXPECT_EQ(again.project, read.project);
}

TEST(AFurnitureModelInAFile, with_sizes_that_cannot_be_is_refused_with_what_can) {
    EXPECT_EQ(findings_of(R"("position": [1, 2, 0], "model": {"kind": "desk",
"sizes": {"width": 16, "height": "low",
"length": 2}})"),
              "room.hanei:4: furniture[0].model.sizes.width: found 16, allowed is 0.5 to 3\n"
              "room.hanei:4: furniture[0].model.sizes.height: found \"low\", expected a number\n"
              "room.hanei:5: furniture[0].model.sizes.length: a desk has no such size\n");
    EXPECT_EQ(findings_of(R"("position": [1, 2, 0], "model": {"kind": ""})"),
              "room.hanei:3: furniture[0].model.kind: a model must have a kind; leave it out if not\n");
    EXPECT_EQ(findings_of(R"("position": [1, 2, 0], "model": {"kind": "desk", "sizes": [1]})"),
              "room.hanei:3: furniture[0].model.sizes: found a list of 1, expected an object {...}\n");
}

TEST(AFurnitureModelInAFile, comes_back_equal_whatever_its_kind_and_sizes) {
    Project project;
    for (const FurnitureKind& kind : furniture_library()) {
        FurnitureModel model{std::string(kind.kind), {}};
        for (const FurnitureSize& size : kind.sizes)
            model.sizes.push_back({std::string(size.name), size.low + (size.high - size.low) / 3.0});
        project.scene = with_furniture(std::move(project.scene), model).scene;
    }
    const ProjectRead read = read_project_text(project_text(project), "room.hanei");
    ASSERT_TRUE(read.project);
    EXPECT_EQ(read.project->scene.furniture, project.scene.furniture);
    for (const Diagnostic& finding : read.findings)
        EXPECT_EQ(finding.message.find("model"), std::string::npos) << to_text(finding);
}

}  // namespace
}  // namespace hanei
