/// Faulty projects and the messages they must give; and files damaged at random.
#include "engine/project/project_file.h"
#include "engine/project/text_file.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <random>
#include <string>

namespace hanei {
namespace {

const std::filesystem::path source = HANEI_SOURCE;

std::string text_of(const std::filesystem::path& file) {
    Diagnostics findings;
    return read_text_file(file, findings).value_or("");
}

TEST(ProjectFaulty, all_faults_of_a_file_are_told_at_once_as_expected) {
    const std::filesystem::path folder = source / "tests/golden/projects";
    const ProjectRead read = read_project_text(text_of(folder / "faulty.hanei"), "faulty.hanei");
    EXPECT_FALSE(read.project.has_value());
    std::string lines;
    for (const Diagnostic& finding : read.findings) lines += to_text(finding) + '\n';
    EXPECT_EQ(lines, text_of(folder / "faulty.findings.txt"));
}

/// Either the file is refused with an error and its place, or what was read can be saved and read again.
void expect_answered(const std::string& text) {
    const ProjectRead read = read_project_text(text, "room.hanei");
    ASSERT_NE(read.project.has_value(), has_errors(read.findings));
    if (!read.project.has_value()) {
        EXPECT_FALSE(read.findings[0].message.empty());
        EXPECT_GT(read.findings[0].place.line, 0);
        return;
    }
    ASSERT_EQ(read_project_text(project_text(*read.project), "room.hanei").project, read.project);
}

TEST(ProjectFaulty, a_file_cut_short_anywhere_is_refused) {
    for (const char* const name : {"computer-room-window", "computer-room-panels", "office"}) {
        const std::string text = text_of(source / "assets/rooms" / (std::string(name) + ".hanei"));
        ASSERT_FALSE(text.empty());
        for (std::size_t length = 0; length + 2 < text.size(); length += 200) {
            const ProjectRead read = read_project_text(text.substr(0, length), "room.hanei");
            EXPECT_FALSE(read.project.has_value()) << length;
            ASSERT_EQ(read.findings.size(), 1U) << length;
            EXPECT_NE(read.findings[0].message.find("no valid JSON"), std::string::npos);
        }
    }
}

TEST(ProjectFaulty, flipped_bytes_never_end_in_anything_but_an_answer) {
    const std::string text = text_of(source / "assets/rooms/computer-room-panels.hanei");
    ASSERT_FALSE(text.empty());
    std::mt19937_64 random(4);
    for (int round = 0; round < 1500; ++round) {
        std::string damaged = text;
        const std::size_t flips = 1 + random() % 3;
        for (std::size_t i = 0; i < flips; ++i)
            damaged[random() % damaged.size()] ^= static_cast<char>(1 << (random() % 8));
        expect_answered(damaged);
    }
}

TEST(ProjectFaulty, digits_and_signs_exchanged_for_others_never_end_in_anything_but_an_answer) {
    const std::string text = text_of(source / "tests/golden/projects/version-1.hanei");
    const std::string marks = "0123456789-.eE[]{},:\" ";
    ASSERT_FALSE(text.empty());
    std::mt19937_64 random(5);
    for (int round = 0; round < 4000; ++round) {
        std::string damaged = text;
        std::size_t at = random() % damaged.size();
        while (marks.find(damaged[at]) == std::string::npos) at = (at + 1) % damaged.size();
        damaged[at] = marks[random() % marks.size()];
        expect_answered(damaged);
    }
}

}  // namespace
}  // namespace hanei
