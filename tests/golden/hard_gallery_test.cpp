/// The gallery of hard cases gives what its table says.
#include "app/hard_cases.h"
#include "engine/project/project_file.h"
#include "engine/project/text_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <set>

namespace hanei {
namespace {

const std::filesystem::path folder = std::filesystem::path{HANEI_SOURCE} / "assets/rooms/hard";

std::vector<HardCase> cases() {
    Diagnostics findings;
    std::vector<HardCase> read = read_hard_cases(folder, findings);
    for (const Diagnostic& finding : findings) ADD_FAILURE() << to_text(finding);
    return read;
}

/// Else the case would not be hard.
bool is_off(const HardOutcome::Figure& figure) {
    return figure.naive && !(std::abs(*figure.naive - figure.wanted.expected) <= figure.wanted.tolerance);
}

TEST(HardGallery, comes_out_as_its_table_says_where_naive_methods_fail) {
    std::ptrdiff_t naive = 0;
    for (const HardCase& wanted : cases()) {
        const HardOutcome outcome = solve_hard_case(folder, wanted);
        for (const std::string& fault : outcome.faults) ADD_FAILURE() << wanted.file << ": " << fault;
        EXPECT_FALSE(outcome.figures.empty() && outcome.findings.empty() && !wanted.escaped_lm)
            << wanted.file << " states nothing";
        const auto& figures = outcome.figures;
        const auto stated =
            std::count_if(figures.begin(), figures.end(), [](const auto& figure) { return figure.naive.has_value(); });
        EXPECT_TRUE(stated == 0 || std::any_of(figures.begin(), figures.end(), is_off)) << wanted.file;
        naive += stated;
    }
    EXPECT_GE(naive, 30);
}

TEST(HardGallery, says_of_every_case_why_it_is_hard_and_of_every_file_what_is_right) {
    std::set<std::string> named;
    for (const HardCase& wanted : cases()) {
        EXPECT_FALSE(wanted.title.empty() || wanted.why.empty() || wanted.naive.empty()) << wanted.file;
        EXPECT_TRUE(named.insert(wanted.file).second) << wanted.file;
        EXPECT_TRUE(std::filesystem::exists(folder / wanted.file)) << wanted.file;
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        EXPECT_TRUE(entry.path().extension() != ".hanei" || named.count(name) == 1) << name;
    }
}

TEST(HardGallery, every_project_can_be_looked_at_and_is_saved_as_the_same_text) {
    for (const HardCase& wanted : cases()) {
        const ProjectRead read = read_project(folder / wanted.file);
        if (!read.project) continue;
        EXPECT_EQ(read.project->scene.title, wanted.title);
        EXPECT_FALSE(read.project->scene.views.empty()) << wanted.file;
        EXPECT_FALSE(read.project->scene.points.empty()) << wanted.file;
        Diagnostics none;
        if (!read.findings.empty()) continue;  // what was mended on the way in is written mended
        EXPECT_EQ(project_text(*read.project), read_text_file(folder / wanted.file, none).value_or("")) << wanted.file;
    }
}

}  // namespace
}  // namespace hanei
