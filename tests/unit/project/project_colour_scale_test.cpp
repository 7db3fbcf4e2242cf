#include "engine/project/project_file.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

std::string findings_of(const std::string& scale) {
    const std::string text = R"({"format": "hanei-project", "version": 1, "colour_scale": )" + scale + "}";
    std::string found;
    for (const Diagnostic& finding : read_project_text(text, "room.hanei").findings) found += to_text(finding) + "\n";
    return found;
}

TEST(ProjectColourScale, is_read_as_it_stands) {
    const ProjectRead read = read_project_text(R"({"format": "hanei-project", "version": 1, "colour_scale":
        {"low_lx": 0, "high_lx": 750, "steps": "linear", "marks_clipped": true, "isolux_lx": [100, 300, 500]}})",
                                               "room.hanei");
    ASSERT_TRUE(read.project);
    EXPECT_EQ(read.project->scene.colour_scale, (ColourScale{0.0, 750.0, "linear", true, {100.0, 300.0, 500.0}, {}}));
}

TEST(ProjectColourScale, is_absent_while_pictures_are_fitted_to_the_light) {
    const ProjectRead read = read_project_text(R"({"format": "hanei-project", "version": 1})", "room.hanei");
    ASSERT_TRUE(read.project);
    EXPECT_FALSE(read.project->scene.colour_scale);
    EXPECT_EQ(project_text(*read.project).find("colour_scale"), std::string::npos);
}

TEST(ProjectColourScale, of_no_range_is_refused) {
    EXPECT_EQ(
        findings_of(R"({"low_lx": 500, "high_lx": 100})"),
        "room.hanei:1: colour_scale.high_lx: colour scale: found 100, allowed is more than the low end, 500 lx\n");
    EXPECT_EQ(findings_of(R"({"low_lx": 500})"),
              "room.hanei:1: colour_scale.high_lx: the field is missing; expected the illuminance at the high end\n");
}

TEST(ProjectColourScale, of_unknown_steps_is_refused) {
    EXPECT_EQ(findings_of(R"({"low_lx": 1, "high_lx": 100, "steps": "cubic"})"),
              "room.hanei:1: colour_scale.steps: colour scale: found \"cubic\", allowed are \"log\", \"linear\" and "
              "\"en\"\n");
}

TEST(ProjectColourScale, whose_levels_fall_is_refused) {
    EXPECT_EQ(findings_of(R"({"low_lx": 1, "high_lx": 100, "isolux_lx": [50, 20]})"),
              "room.hanei:1: colour_scale.isolux_lx[1]: colour scale: found 20, allowed are rising levels above 0 lx, "
              "1e+07 lx at most\n");
}

}  // namespace
}  // namespace hanei
